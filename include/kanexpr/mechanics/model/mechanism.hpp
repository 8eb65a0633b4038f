#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/body.hpp>
#include <kanexpr/mechanics/model/frame.hpp>
#include <kanexpr/mechanics/model/point.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

namespace kanexpr::mechanics {

/// A quantity that the caller specifies as a function of time; its symbol and its rate are inputs.
struct prescribed_rate {
  expression quantity{};
  expression rate{};
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
  sequence<frame> frames{};
  sequence<point> points{};
  sequence<body> bodies{};
  method derived_by = method::kane;

  static constexpr int inertial = 0;

  constexpr explicit mechanism(graph& owner)
      : g(&owner), time(symbolic::variable(owner, {symbolic::symbol_kind::time, name("t"), 0})) {}
  explicit mechanism(const mechanism&) = default; // uses the same graph
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
    visit(self.auxiliary_speeds);
    visit(self.frames);
    visit(self.points);
    visit(self.bodies);
    visit(self.derived_by);
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
  /// Takes the rate of each coordinate as a speed, named after the coordinate with a prime.
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

  /// Adds a speed that is zero at all times and belongs to no state.
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
