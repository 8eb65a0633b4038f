#pragma once

#include <kanexpr/mechanics/model/body.hpp>
#include <kanexpr/mechanics/model/frame.hpp>
#include <kanexpr/mechanics/model/point.hpp>

namespace kanexpr::mechanics {

struct force {
  int point = none;
  vector value{};
  int against = none; ///< the point that feels the opposite; none: nothing of the system does
};

struct torque {
  int frame = none;
  vector value{};
  int against = none; ///< the frame that feels the opposite
};

/// A straight massless spring and a damper beside it. They pull two points to each other with the force
/// stiffness·(distance − length) + damping·(rate of the distance).
struct spring_damper {
  int point = none;
  int other = none;
  expression stiffness{}, length{}, damping{};
};

/// A torque −damping·(ω_frame − ω_against) on what is fixed in `frame`, and its opposite on `against`.
struct torsional_damper {
  int frame = none;
  int against = none;
  expression damping{};
};

/// A velocity constraint: a scalar, linear in the speeds, that vanishes. Where it is the component of a
/// vector along a direction, both are kept, for the rate of the vector is cheaper to form than that of the
/// scalar.
struct velocity_constraint {
  expression value{};
  vector vanishing{}; ///< no parts: there is only the scalar
  vector direction{};
};

/// A quantity that the caller knows as a function of time: its symbol is an input, and so is its rate.
struct prescribed_rate {
  expression quantity{};
  expression rate{};
};

/// How the equations of motion are derived.
enum class method : unsigned char {
  kane,
  lagrange, ///< the speeds are the rates of the coordinates, in their order
};

/// A mechanical system as plain values: what models written as types are read into, what programs build
/// while they run, and what every step of the mechanics starts from. Frame 0 is the inertial frame.
struct mechanism {
  graph* g = nullptr;
  sequence<expression> coordinates{}, speeds{}, parameters{},
      inputs{};                                           ///< in the order of the state and argument vectors
  sequence<expression> coordinate_rates{}, speed_rates{}; ///< the symbols dq/dt and du/dt
  expression time;
  sequence<prescribed_rate> prescribed_rates{};
  sequence<expression> kinematics{}; ///< expressions that vanish, linear in the coordinate rates
  sequence<expression> configuration_constraints{}; ///< of coordinates, parameters and time, that vanish
  sequence<velocity_constraint> velocity_constraints{};
  /// Linear in u̇, that vanish; empty: derived from the others.
  sequence<expression> acceleration_constraints{};
  sequence<int> dependent_coordinates{}, dependent_speeds{}; ///< by position; empty: the library chooses
  sequence<expression> auxiliary_speeds{}; ///< that are zero and bring out a force that does no work
  sequence<frame> frames{};
  sequence<point> points{};
  sequence<body> bodies{};
  sequence<force> forces{};
  sequence<torque> torques{};
  sequence<expression> potential_energies{}; ///< of coordinates, parameters, time and inputs; others are
                                             ///< those of gravity and of springs
  sequence<spring_damper> spring_dampers{};
  sequence<torsional_damper> torsional_dampers{};
  bool has_gravity = false;
  vector gravity{}; ///< acceleration of free fall, on every body
  method derived_by = method::kane;
  bool has_lagrangian = false;
  expression lagrangian{}; ///< in place of the energies of bodies

  static constexpr int inertial = 0;

  constexpr explicit mechanism(graph& owner)
      : g(&owner), time(symbolic::variable(owner, {symbolic::symbol_kind::time, name("t"), 0})) {}
  explicit mechanism(const mechanism&) = default; // of the same graph
  mechanism& operator=(const mechanism&) = delete;
  template <class Self, class Visit>
  static constexpr void each_member(Self& self, Visit&& visit) {
    visit(self.coordinates);
    visit(self.speeds);
    visit(self.parameters);
    visit(self.inputs);
    visit(self.coordinate_rates);
    visit(self.speed_rates);
    visit(self.time);
    visit(self.prescribed_rates);
    visit(self.kinematics);
    visit(self.configuration_constraints);
    visit(self.velocity_constraints);
    visit(self.acceleration_constraints);
    visit(self.dependent_coordinates);
    visit(self.dependent_speeds);
    visit(self.auxiliary_speeds);
    visit(self.frames);
    visit(self.points);
    visit(self.bodies);
    visit(self.forces);
    visit(self.torques);
    visit(self.potential_energies);
    visit(self.spring_dampers);
    visit(self.torsional_dampers);
    visit(self.has_gravity);
    visit(self.gravity);
    visit(self.derived_by);
    visit(self.has_lagrangian);
    visit(self.lagrangian);
  }

  constexpr expression zero() const { return {*g, graph::zero}; }
  constexpr expression one() const { return {*g, graph::one}; }
  constexpr expression number(double value) const { return symbolic::constant(*g, symbolic::real(value)); }

  constexpr expression coordinate(const name& called) {
    const int i = coordinates.size();
    coordinates.push(symbolic::variable(*g, {symbolic::symbol_kind::coordinate, called, i}));
    coordinate_rates.push(symbolic::variable(*g, {symbolic::symbol_kind::coordinate_rate, called, i}));
    return coordinates[i];
  }
  constexpr expression speed(const name& called) {
    const int i = speeds.size();
    speeds.push(symbolic::variable(*g, {symbolic::symbol_kind::speed, called, i}));
    speed_rates.push(symbolic::variable(*g, {symbolic::symbol_kind::speed_rate, called, i}));
    return speeds[i];
  }
  /// The rate of each coordinate as a speed, which carries its name and a prime.
  constexpr void take_rates_as_speeds() {
    for (int i = 0; i < coordinates.size(); ++i) {
      name rate = g->symbol_at(coordinates[i].node()).called;
      rate.append("'");
      kinematics.push(coordinate_rates[i] - speed(rate));
    }
  }
  constexpr expression parameter(const name& called) {
    const int i = parameters.size();
    parameters.push(symbolic::variable(*g, {symbolic::symbol_kind::parameter, called, i}));
    return parameters[i];
  }
  /// The ways in which the system can be thought to move: its speeds, then its auxiliary speeds.
  constexpr int ways() const { return speeds.size() + auxiliary_speeds.size(); }
  constexpr expression way(int i) const {
    return i < speeds.size() ? speeds[i] : auxiliary_speeds[i - speeds.size()];
  }

  /// A speed that is zero at all times and is in no state.
  constexpr expression auxiliary_speed(const name& called) {
    const int i = auxiliary_speeds.size();
    auxiliary_speeds.push(symbolic::variable(*g, {symbolic::symbol_kind::auxiliary_speed, called, i}));
    return auxiliary_speeds[i];
  }
  constexpr expression input(const name& called) {
    const int i = inputs.size();
    inputs.push(symbolic::variable(*g, {symbolic::symbol_kind::input, called, i}));
    return inputs[i];
  }
};

} // namespace kanexpr::mechanics
