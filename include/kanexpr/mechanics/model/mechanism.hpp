#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/flexible_body.hpp>
#include <kanexpr/mechanics/model/formulation.hpp>
#include <kanexpr/mechanics/model/frame.hpp>
#include <kanexpr/mechanics/model/vector.hpp>
#include <kanexpr/symbolic/graph/composition.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>
#include <kanexpr/units/unit.hpp>

namespace kanexpr::mechanics {

struct point {
  name called{};
  int parent = none;    ///< none: an origin, fixed in the inertial frame
  vector offset{};      ///< relative to the parent
  int fixed_in = none;  ///< both points are fixed in this frame (two-point theorem)
  int reference = none; ///< the frame in which a declared velocity is measured
  vector velocity{};
  bool moves_apart = false; ///< declared not to match the position
  bool from_parent = false; ///< the declared velocity is relative to the parent, which is fixed in
                            ///< `reference`

  constexpr bool has_declared_velocity() const { return reference != none; }
  /// Declares the velocity in the frame `in`, which is used instead of the derived one. The one-point theorem
  /// applies if the velocity is relative to the parent, which is fixed in this frame.
  constexpr void declare_velocity(int in, const vector& value, bool is_from_parent) {
    reference = in;
    velocity = value;
    from_parent = is_from_parent;
  }
};

/// A particle, or a rigid body if it has a frame.
struct body {
  name called{};
  int center = none; ///< the mass center
  int frame = none;  ///< none: a particle
  expression mass{};
  dyadic inertia{};
  int about = none;             ///< the reference point of the inertia
  bool inertia_changes = false; ///< declared to change in the body frame
  bool effective = false;       ///< need not be the inertia of a mass distribution

  /// Whether the inertia is given about a point other than the mass center.
  constexpr bool is_off_center() const { return about != none && about != center; }
};

/// A quantity that the caller specifies as a function of time; its symbol and its rate are inputs.
struct prescribed_rate {
  expression quantity{};
  expression rate{};
};

/// The unit that a model states for a symbol, or that the definition of the symbol implies.
struct stated_unit {
  expression symbol{};
  units::unit unit{};
  bool is_implied = false; ///< the unit alone is no reason to check the units of the model
};

/// A quantity of a part of the system that is not stored as given, with the unit that it must have: "the
/// length of beam " and "B".
struct expected_unit {
  expression value{};
  units::unit unit{};
  name what{}, whose{};
};

/// The value of a function of several operands in a model that is read for its units. The symbol denotes it
/// by the words of the model.
struct function_value {
  expression symbol{};
  symbolic::composition function{};
  sequence<expression> operands{};
};

/// The method by which the equations of motion are derived.
enum class method : unsigned char {
  kane,
  lagrange, ///< the speeds are the rates of the coordinates, in the same order
};

/// The kinematics and masses of a system as plain values: coordinates, speeds and the equations between them,
/// frames, points and bodies. Its loads are in `loads`, its constraints in `given_constraints`. Frame 0 is
/// the inertial frame.
struct mechanism {
  graph* g = nullptr;
  sequence<expression> coordinates{}, speeds{}, parameters{},
      inputs{};                                           ///< in the order of the state and argument vectors
  sequence<expression> coordinate_rates{}, speed_rates{}; ///< the symbols dq/dt and du/dt
  expression time;
  sequence<prescribed_rate> prescribed_rates{};
  sequence<expression> kinematics{};       ///< expressions that vanish, linear in the coordinate rates
  sequence<expression> auxiliary_speeds{}; ///< zero at all times; they bring into evidence forces that do no
                                           ///< work
  int state_variables = 0;                 ///< the last of the speeds that are state variables
  sequence<frame> frames{};
  sequence<point> points{};
  sequence<body> bodies{};
  sequence<flexible_body> flexible_bodies{};
  method derived_by = method::kane;
  formulation formulated{};             ///< how the equations are formed, as far as the model determines it
  sequence<stated_unit> stated_units{}; ///< empty if the model states no unit, and once they are checked
  sequence<expected_unit> expected_units{};
  sequence<function_value> function_values{}; ///< only while the model is read for its units

  static constexpr int inertial = 0;

  constexpr explicit mechanism(graph& owner)
      : g(&owner), time(symbolic::variable(owner, {symbolic::symbol_kind::time, name("t"), 0})) {}
  explicit mechanism(const mechanism&) = default; // uses the same graph
  mechanism& operator=(const mechanism&) = delete;
  template <class Self, class Visit>
  static constexpr void each_member(Self& self, Visit&& visit) {
    visit(self.coordinates, self.speeds, self.parameters, self.inputs, self.coordinate_rates,
          self.speed_rates, self.time, self.prescribed_rates, self.kinematics, self.auxiliary_speeds,
          self.state_variables, self.frames, self.points, self.bodies, self.flexible_bodies, self.derived_by,
          self.formulated, self.stated_units, self.expected_units);
  }

  /// Discards what was read only for units, after the given number of expected units.
  constexpr void forget_units_after(int expected) {
    while (expected_units.size() > expected) expected_units.pop();
    function_values.clear();
  }
  /// Whether the model itself states a unit, so that all units are inferred and must fit.
  constexpr bool checks_units() const {
    for (const stated_unit& s : stated_units)
      if (!s.is_implied) return true;
    return false;
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
  /// Adds a state variable z, a scalar with a rate ż that is neither a coordinate nor a speed. It is kept as
  /// a further speed that moves nothing and has the mass 1, so that its equation of motion is ż = f (see
  /// `state_rate`). State variables follow all speeds.
  constexpr expression state_variable(const name& called) {
    ++state_variables;
    return speed(called);
  }
  /// The number of speeds that are not state variables; these come first.
  constexpr int speeds_of_motion() const { return speeds.size() - state_variables; }
  /// Makes the rate of each coordinate a speed, named after the coordinate with a prime appended.
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
  /// The number of speeds, including auxiliary speeds, which come last.
  constexpr int ways() const { return speeds.size() + auxiliary_speeds.size(); }
  constexpr expression way(int i) const {
    return i < speeds.size() ? speeds[i] : auxiliary_speeds[i - speeds.size()];
  }

  /// Adds a speed that is zero at all times and is not part of the state.
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
