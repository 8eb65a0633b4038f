#pragma once

#include <kanexpr/mechanics/model/components.hpp>

namespace kanexpr::mechanics {

using symbolic::name;

/// What stands for "none" among the numbers of frames, points and bodies.
inline constexpr int none = -1;

/// A vector as a sum over frames: each part is given by its components in the axes of one frame.
struct vector {
  struct part {
    int frame = none;
    components value{};
  };
  sequence<part> parts{};

  constexpr void add(int frame, const components& value) {
    for (part& p : parts)
      if (p.frame == frame) {
        p.value += value;
        return;
      }
    parts.push({frame, value});
  }
  constexpr void add(const vector& other) {
    for (const part& p : other.parts) add(p.frame, p.value);
  }
  constexpr void subtract(const vector& other) {
    for (const part& p : other.parts) add(p.frame, -p.value);
  }
  constexpr bool is_zero() const {
    for (const part& p : parts)
      if (!p.value.is_zero()) return false;
    return true;
  }
};

constexpr vector operator*(expression s, const vector& v) {
  vector out;
  for (const vector::part& p : v.parts) out.parts.push({p.frame, scaled(s, p.value)});
  return out;
}

constexpr vector operator+(vector a, const vector& b) {
  a.add(b);
  return a;
}
constexpr vector operator-(vector a, const vector& b) {
  a.subtract(b);
  return a;
}
constexpr vector operator-(const vector& v) {
  vector turned;
  turned.subtract(v);
  return turned;
}

/// A dyadic as a sum over pairs of frames: Σ value(i,j) left.i ⊗ right.j.
struct dyadic {
  struct part {
    int left = none;
    int right = none;
    matrix3 value{};
  };
  sequence<part> parts{};

  constexpr void add(int left, int right, const matrix3& value) {
    for (part& p : parts)
      if (p.left == left && p.right == right) {
        for (int i = 0; i < 3; ++i) p.value.row[i] += value.row[i];
        return;
      }
    parts.push({left, right, value});
  }
  constexpr void add(const dyadic& other) {
    for (const part& p : other.parts) add(p.left, p.right, p.value);
  }
};

constexpr dyadic operator*(expression s, const dyadic& d) {
  dyadic scaled;
  for (const dyadic::part& p : d.parts) {
    matrix3 value;
    for (int i = 0; i < 3; ++i) value.row[i] = s * p.value.row[i];
    scaled.parts.push({p.left, p.right, value});
  }
  return scaled;
}

constexpr dyadic operator+(dyadic a, const dyadic& b) {
  a.add(b);
  return a;
}

/// How a frame is oriented relative to its parent.
enum class orientation {
  inertial,
  about_basis, ///< turned by `angle` about the parent's axis number `axis`
  about_axis, ///< turned by `angle` about `direction`, a unit vector fixed in the parent; `to_parent` follows
  matrix,     ///< `to_parent` given
};

struct frame {
  name called{};
  int parent = none;
  orientation kind = orientation::inertial;
  int axis = 0;
  expression angle{};
  components direction{}; ///< in the parent's axes
  matrix3 to_parent{};    ///< direction cosine matrix: v in the parent's axes = to_parent · v in the frame's
  sequence<expression> quaternion{}; ///< e0, e1, e2, e3, where the frame was given so; `to_parent` follows
  int reference = none;              ///< the frame that a declared angular velocity is measured in
  vector angular_velocity{};
  bool turns_apart = false; ///< from its orientation, on purpose

  constexpr bool turns_by_declaration() const { return reference != none; }
};

struct point {
  name called{};
  int parent = none;    ///< none: an origin, fixed in the inertial frame
  vector offset{};      ///< from the parent
  int fixed_in = none;  ///< both points are fixed in this frame (two-point theorem)
  int reference = none; ///< the frame that a declared velocity is measured in
  vector velocity{};

  constexpr bool moves_by_declaration() const { return reference != none; }
};

struct body {
  name called{};
  int center = none; ///< the point of the mass centre
  int frame = none;  ///< none: a particle
  expression mass{};
  dyadic inertia{};
  int about = none;             ///< the point that the inertia is about
  bool inertia_changes = false; ///< as the body sees it, on purpose
  bool effective = false;       ///< the inertia need not be that of a distribution of mass
};

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
