#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/constraints/given_constraints.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/motion/generic_states.hpp>
#include <kanexpr/mechanics/motion/motion.hpp>
#include <kanexpr/mechanics/motion/point_jacobian.hpp>
#include <kanexpr/mechanics/skeleton/skeleton.hpp>
#include <kanexpr/mechanics/skeleton/vector_substitution.hpp>
#include <kanexpr/symbolic/derivatives/differentiate.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/live_nodes.hpp>

namespace kanexpr::mechanics {

/// All constraints of a mechanism. The constraints on its speeds are J u + J_a u_a + c = 0: the velocity
/// constraints of the model, followed by the rates of its configuration constraints.
///
/// A velocity constraint φ that is not linear in the speeds has the row J = ∂φ/∂u, which depends on them, and
/// no c. Its rate is J u̇ + γ, and its forces act along J (Chetaev's condition), like those of linear ones.
struct constraints {
  sequence<expression> on_configuration{};       ///< as given
  sequence<int> numbers{};                       ///< their numbers in the model, starting at 1
  sequence<expression> redundant{};              ///< configuration constraints that are not used in solving
  sequence<int> redundant_numbers{};             ///< their numbers in the model
  sequence<expression> on_accelerations{};       ///< as given
  sequence<velocity_constraint> on_velocities{}; ///< without auxiliary speeds
  sequence<int> station{}; ///< for each velocity constraint, the station whose velocity component it sets to
                           ///< zero, or none
  sequence<int> of_configuration{}; ///< for each velocity constraint, the configuration constraint whose rate
                                    ///< it is, or none
  symbolic::matrix jacobian{};      ///< J, a column for each speed
  symbolic::matrix by_auxiliary{};  ///< J_a, a column for each auxiliary speed
  sequence<expression> remainder{}; ///< c, the part without speeds, of linear constraints
  int nonlinear = 0;                ///< the number of velocity constraints that are not linear in the speeds
  sequence<expression> repeated{};  ///< omitted rates; empty if no constraint has a part without speeds
  sequence<int> repeats{};          ///< the configuration constraints of these rates

  constexpr int size() const { return on_velocities.size(); }
  /// The number, in the model, of the configuration constraint of which constraint `i` is the rate; none if
  /// there is no such constraint.
  constexpr int number_of_rate(int i) const {
    return of_configuration[i] == none ? none : numbers[of_configuration[i]];
  }
  constexpr sequence<expression> velocity_residual() const {
    sequence<expression> residual;
    for (const velocity_constraint& c : on_velocities) residual.push(c.value);
    return residual;
  }
};

/// The first rows and columns of a matrix.
constexpr symbolic::matrix leading_block(graph& g, const symbolic::matrix& a, int rows, int columns) {
  symbolic::matrix out(g, rows, columns);
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) out(i, j) = a(i, j);
  return out;
}

namespace detail {

/// Whether any of the expressions depends on a speed.
constexpr bool depend_on_speeds(const mechanism& m, const sequence<expression>& all) {
  sequence<int> nodes, speeds;
  for (const expression& e : all)
    if (!e.is_constant()) nodes.push(e.node());
  if (nodes.empty()) return false;
  for (int j = 0; j < m.ways(); ++j) speeds.push(m.way(j).node());
  return symbolic::depends_on(*m.g, nodes, speeds);
}

/// The station whose velocity a constraint restricts, if there is exactly one and its direction does not
/// depend on the speeds.
constexpr int station_of(motion& k, const velocity_constraint& c) {
  if (c.vanishing.parts.size() != 1) return none;
  sequence<expression> direction;
  c.direction.each_entry([&](expression e) { direction.push(e); });
  if (depend_on_speeds(*k.skeleton_used().model, direction)) return none;
  return k.station_with_velocity(c.vanishing.parts[0].value, c.vanishing.parts[0].frame);
}

/// The partial derivatives of each constraint with respect to all speeds. For the velocity of a point along a
/// direction, they follow from the geometry; scalars are differentiated in forward mode, one speed at a time.
constexpr symbolic::matrix constraint_jacobian(const skeleton& s, const sequence<velocity_constraint>& all,
                                               const sequence<int>& stations) {
  const mechanism& m = *s.model;
  symbolic::matrix jacobian(*m.g, all.size(), m.ways());
  for (int i = 0; i < all.size(); ++i) {
    if (stations[i] == none) continue;
    const sequence<expression> share = point_jacobian(s, stations[i]).along(all[i].direction);
    for (int j = 0; j < m.ways(); ++j) jacobian(i, j) = share[j];
  }
  symbolic::differentiation by_speed(*m.g);
  for (int j = 0; j < m.ways(); ++j) {
    by_speed.restart();
    by_speed.set_rate(m.way(j), m.one());
    for (int i = 0; i < all.size(); ++i)
      if (stations[i] == none) jacobian(i, j) = by_speed.of(all[i].value);
  }
  return jacobian;
}

/// Marks the constraints that are not linear in the speeds: their rows of the Jacobian depend on them. Only
/// the first `given` constraints can be nonlinear, and only those without a station.
constexpr sequence<char> nonlinear_rows(const mechanism& m, const symbolic::matrix& jacobian,
                                        const sequence<int>& stations, int given) {
  sequence<char> marks(jacobian.rows, 0);
  sequence<sequence<expression>> rows;
  sequence<expression> all;
  for (int i = 0; i < given; ++i) {
    rows.push({});
    for (int j = 0; j < jacobian.columns && stations[i] == none; ++j) rows[i].push(jacobian(i, j));
    all.append(rows[i]);
  }
  if (!depend_on_speeds(m, all)) return marks;
  for (int i = 0; i < given; ++i) marks[i] = depend_on_speeds(m, rows[i]) ? 1 : 0;
  return marks;
}

} // namespace detail

/// Forms the constraints of a mechanism. Omits the rate of a configuration constraint if the velocity
/// constraints of the model already imply it; many models contain both.
constexpr constraints form_constraints(motion& k, const given_constraints& from) {
  const skeleton& s = k.skeleton_used();
  const mechanism& m = *s.model;
  known_rates known(m, s.coordinate_rates);
  without_auxiliary_speeds drop(m);

  sequence<velocity_constraint> all;
  for (const velocity_constraint& c : from.on_velocities)
    all.push({known.in(c.value), known.in(c.vanishing), known.in(c.direction)});
  const int given = all.size();
  for (int i = 0; i < from.on_configuration.size(); ++i) {
    expression rate = k.rate(from.on_configuration[i]);
    if (!from.rates_by_auxiliary.empty()) rate += from.rates_by_auxiliary[i];
    all.push({rate, {}, {}});
  }
  sequence<int> stations;
  for (const velocity_constraint& c : all) stations.push(detail::station_of(k, c));
  const symbolic::matrix jacobian = detail::constraint_jacobian(s, all, stations);
  const sequence<char> is_nonlinear = detail::nonlinear_rows(m, jacobian, stations, given);

  sequence<char> kept(all.size(), 1);
  if (given > 0 && given < all.size()) {
    // the rate of a configuration constraint and an equivalent velocity constraint may contain different
    // auxiliary speeds
    const sequence<char> new_by_itself =
        independent_rows(leading_block(*m.g, jacobian, all.size(), m.speeds.size()), &m);
    for (int i = given; i < all.size(); ++i) kept[i] = new_by_itself[i];
  }

  constraints out;
  out.on_configuration = from.on_configuration;
  out.on_accelerations = from.on_accelerations;
  symbolic::substitution at_rest(*m.g);
  for (int j = 0; j < m.ways(); ++j) at_rest.replace(m.way(j), m.zero());
  bool is_all_by_speeds = true;
  for (int i = 0; i < all.size(); ++i) {
    const bool is_linear = is_nonlinear[i] == 0;
    const expression remainder = is_linear ? at_rest.in(all[i].value) : m.zero();
    is_all_by_speeds = is_all_by_speeds && remainder.is_zero();
    if (kept[i] == 0) {
      out.repeated.push(drop.in(all[i].value));
      out.repeats.push(i - given);
      continue;
    }
    out.on_velocities.push({drop.in(all[i].value), drop.in(all[i].vanishing), all[i].direction});
    out.station.push(stations[i]);
    out.of_configuration.push(i < given ? none : i - given);
    out.remainder.push(remainder);
    out.nonlinear += is_linear ? 0 : 1;
  }
  if (is_all_by_speeds) out.repeated.clear(), out.repeats.clear();
  const int speeds = m.speeds.size();
  out.jacobian = symbolic::matrix(*m.g, out.size(), speeds);
  out.by_auxiliary = symbolic::matrix(*m.g, out.size(), m.ways() - speeds);
  for (int i = 0, row = 0; i < all.size(); ++i) {
    if (kept[i] == 0) continue;
    for (int j = 0; j < m.ways(); ++j) {
      expression entry = jacobian(i, j);
      if (is_nonlinear[i] != 0) entry = drop.in(entry);
      (j < speeds ? out.jacobian(row, j) : out.by_auxiliary(row, j - speeds)) = entry;
    }
    ++row;
  }
  return out;
}

namespace detail {

/// Whether the constraints set the velocity in constraint `i` to zero along all directions, so that the
/// rotation of the directions does not matter.
constexpr bool fixes_velocity(const constraints& c, int i) {
  int directions = 0;
  for (int j = 0; j < c.size(); ++j)
    if (c.station[j] == c.station[i]) ++directions;
  return directions == 3;
}

} // namespace detail

/// The rate of constraint `i` in a motion: J u̇ + γ, or γ for a motion without rates of the speeds.
///
/// For the velocity of a point along a direction, it is a·d + v·ḋ, with the acceleration from the dynamics.
constexpr expression rate_of_constraint(motion& k, const constraints& c, int i) {
  const velocity_constraint& own = c.on_velocities[i];
  if (c.station[i] == none) return k.rate(own.value);
  const skeleton& s = k.skeleton_used();
  const mechanism& m = *s.model;
  const vector& v = own.vanishing;
  expression rate = m.zero();
  for (const vector::part& d : own.direction.parts) {
    const expression whole =
        dot(express(m, k.acceleration(c.station[i]), v.parts[0].frame, d.frame), d.value);
    rate += whole - dot(express(m, k.ground_acceleration(), d.frame), d.value);
    if (detail::fixes_velocity(c, i)) continue;
    const components angular_velocity =
        express(m, k.angular_velocity(d.frame), s.working_axes[d.frame], d.frame);
    const components change{k.rate(d.value.x), k.rate(d.value.y), k.rate(d.value.z)};
    const components velocity = express(m, v, d.frame);
    rate += dot(velocity, change + cross(angular_velocity, d.value));
  }
  return rate;
}

} // namespace kanexpr::mechanics
