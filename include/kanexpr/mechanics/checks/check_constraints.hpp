#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/constraints/consistent_states.hpp>
#include <kanexpr/mechanics/constraints/dependent_speeds.hpp>
#include <kanexpr/mechanics/constraints/redundant_constraints.hpp>
#include <kanexpr/mechanics/model/check_contents.hpp>
#include <kanexpr/mechanics/model/contents.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/wording.hpp>
#include <kanexpr/mechanics/skeleton/skeleton.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/sizes/definite_sign.hpp>

#include <string_view>

/// Checks the contents and the number of constraints, and whether they are singular in every configuration.
namespace kanexpr::mechanics {

/// Reports configuration constraints that vanish identically, as happens for planar loops modeled in space.
constexpr sentence vanishing_constraints(const given_constraints& given) {
  sequence<int> numbers;
  for (int i = 0; i < given.on_configuration.size(); ++i)
    if (given.on_configuration[i].is_zero() && !given.redundant.contains(i + 1)) numbers.push(i + 1);
  return dropping(numbers, " contains no coordinate", " contain no coordinate");
}

namespace detail {

constexpr sentence check_configuration_constraint(const mechanism& m, const contents& held,
                                                  const given_constraints& given, int i) {
  const expression f = given.on_configuration[i];
  const sentence which({"configuration constraint ", base::counted(i + 1).view()});
  if (const sentence found = check_no_rates(m, held, f, which.view(), {})) return found;
  if (const sentence found = check_prescribed(m, held, f, 2, which.view())) return found;
  if (held.holds(f, contents::kind::coordinate) || given.redundant.contains(i + 1)) return {};
  return f.is_zero() ? vanishing_constraints(given) : sentence({which.view(), " contains no coordinate"});
}

constexpr sentence check_velocity_constraint(const mechanism& m, const contents& held, expression v, int i) {
  using kind = contents::kind;
  const sentence which({"velocity constraint ", base::counted(i + 1).view()});
  if (const sentence rate = symbol_in(m, held, v, {kind::speed_rate}))
    return sentence({which.view(), " contains the ", rate.view()});
  if (const sentence found = check_no_state_variable(m, held, v, which.view())) return found;
  if (const sentence found = check_prescribed(m, held, v, 1, which.view())) return found;
  if (held.holds_any(v, {kind::speed, kind::coordinate_rate})) return {};
  const sentence coordinate = symbol_in(m, held, v, {kind::coordinate});
  if (!coordinate) return sentence({which.view(), " contains no ", a_speed(m)});
  return sentence({which.view(), " contains the ", coordinate.view(), " but no ", a_speed(m),
                   "; move it to configuration_constraints<...>"});
}

} // namespace detail

/// Checks which symbols the constraints of a model contain.
constexpr sentence check_contents_of_constraints(const mechanism& m, const given_constraints& given) {
  if (given.on_configuration.empty() && given.on_velocities.empty() && given.on_accelerations.empty())
    return {};
  const contents held(*m.g);
  for (int i = 0; i < given.on_configuration.size(); ++i)
    if (const sentence found = detail::check_configuration_constraint(m, held, given, i)) return found;
  for (int i = 0; i < given.on_velocities.size(); ++i)
    if (const sentence found = detail::check_velocity_constraint(m, held, given.on_velocities[i].value, i))
      return found;
  return {};
}

namespace detail {

/// Whether a constraint is violated wherever the first `configurations` configuration constraints and the
/// first `velocities` constraints on the speeds hold. Its gradient must be a linear combination of theirs.
constexpr bool contradicts(const skeleton& s, const constraints& c, const symbolic::matrix& configuration,
                           int configurations, int velocities, expression constraint) {
  const sequence<expression> last{constraint};
  consistent_states states(s, configuration, configurations, c, velocities, last);
  return first_that_never_vanishes(states, last) == 0;
}

/// Checks the rates of configuration constraints that are omitted because velocity constraints imply them.
constexpr sentence check_repeated_rates(const skeleton& s, const constraints& c,
                                        const symbolic::matrix& configuration) {
  if (c.repeated.empty()) return {};
  consistent_states anywhere(s, configuration, 0, c, c.size(), c.repeated);
  if (first_that_never_vanishes(anywhere, c.repeated) == none)
    return {}; // they vanish in every configuration, as in most models
  consistent_states states(s, configuration, configuration.rows, c, c.size(), c.repeated);
  const int i = first_that_never_vanishes(states, c.repeated);
  if (i == none) return {};
  int on_velocities = 0;
  for (int of_configuration : c.of_configuration)
    if (of_configuration == none) ++on_velocities;
  return sentence(
      {on_velocities == 1 ? "velocity constraint 1 contradicts" : "the velocity constraints contradict",
       " the rate of configuration constraint ", base::counted(c.numbers[c.repeats[i]]).view()});
}

constexpr bool has_entry_in_row(const symbolic::matrix& a, int i) {
  for (int j = 0; j < a.columns; ++j)
    if (!a(i, j).is_zero()) return true;
  return false;
}
constexpr bool has_entry_in_column(const symbolic::matrix& a, int j) {
  for (int i = 0; i < a.rows; ++i)
    if (!a(i, j).is_zero()) return true;
  return false;
}

/// Returns, for example, "velocity constraint 1" or "the rate of configuration constraint 3".
constexpr sentence constraint_called(const constraints& c, int i) {
  const int number = c.number_of_rate(i);
  if (number != none)
    return sentence({"the rate of configuration constraint ", base::counted(number).view()});
  return sentence({"velocity constraint ", base::counted(i + 1).view()});
}

/// Reports nonlinear constraints that fix no motion: u² = 0, whose derivatives with respect to the speeds
/// vanish where it holds, u v = 1 with u² + v² = 2, whose derivatives depend on each other there, and u² =
/// −1, which holds nowhere.
constexpr sentence check_slopes(const skeleton& s, const constraints& c,
                                const symbolic::matrix& configuration) {
  if (c.nonlinear == 0) return {};
  const std::string_view speeds = s.model->derived_by == method::kane ? "speeds" : "rates of the coordinates";
  for (int i = 0; i < c.size(); ++i)
    if (symbolic::has_definite_sign(c.on_velocities[i].value))
      return sentence({constraint_called(c, i).view(), " holds for no ", speeds});
  consistent_states states(s, configuration, configuration.rows, c, c.size(), {});
  sentence found;
  for (int attempts = 0; attempts < 4; ++attempts) {
    states.next();
    if (const int i = states.row_that_vanished(); i != none)
      found = sentence({"the derivatives of ", constraint_called(c, i).view(), " with respect to the ",
                        speeds, " vanish wherever it holds"});
    else if (const int j = states.row_that_became_dependent(); j != none)
      found = sentence({"wherever the constraints on the velocities hold, the derivatives of ",
                        constraint_called(c, j).view(), " with respect to the ", speeds,
                        " are a combination of those of the preceding ones"});
    else
      return {};
  }
  return found;
}

constexpr sentence check_configuration(const skeleton& s, const constraints& c,
                                       const symbolic::matrix& configuration, const sequence<numbers>& by_q) {
  const int first = independent_rows(by_q, configuration.rows).find(0);
  if (first < 0) return {};
  const name number = base::counted(c.numbers[first]);
  if (first == 0)
    return sentence(
        {"configuration constraint ", number.view(), " constrains no coordinate in any configuration"});
  if (contradicts(s, c, configuration, first, 0, c.on_configuration[first]))
    return sentence({"configuration constraint ", number.view(), " contradicts the preceding ones"});
  return dropping({c.numbers[first]}, " follows from the preceding ones in every configuration", {});
}

constexpr sentence check_velocities(const skeleton& s, const constraints& c,
                                    const symbolic::matrix& configuration, const sequence<numbers>& by_u) {
  const int first = independent_rows(by_u, c.size()).find(0);
  if (first < 0) return {};
  const sentence which = constraint_called(c, first);
  if (first == 0)
    return sentence({which.view(), " constrains no ", a_speed(*s.model), " in any configuration"});
  const bool is_false =
      contradicts(s, c, configuration, configuration.rows, first, c.on_velocities[first].value);
  const bool is_given = c.number_of_rate(first) == none;
  return sentence({which.view(), is_false ? " contradicts " : " follows from ",
                   is_given ? "the preceding ones" : "the other constraints",
                   is_false ? "" : " in every configuration"});
}

} // namespace detail

/// Reports constraints that leave no motion, follow from the preceding ones, or contradict them. `by_q` and
/// `by_u` are the Jacobians of the configuration constraints and of the constraints on the speeds,
/// equilibrated, at generic states.
constexpr sentence check_constraints(const skeleton& s, const constraints& c,
                                     const symbolic::matrix& configuration, const sequence<numbers>& by_q,
                                     const sequence<numbers>& by_u) {
  const mechanism& m = *s.model;
  const int speeds = m.speeds_of_motion(), coordinates = m.coordinates.size();
  if (configuration.rows > coordinates)
    return sentence({"there are ", several(configuration.rows, "configuration constraint").view(), " for ",
                     several(coordinates, "coordinate").view(),
                     advice_on_redundant(m, configuration, c).view()});
  if (const sentence found = detail::check_configuration(s, c, configuration, by_q)) return found;
  for (int i = 0; i < c.size(); ++i)
    if (!detail::has_entry_in_row(c.jacobian, i))
      return sentence({detail::constraint_called(c, i).view(), " contains no ", a_speed(m)});
  if (c.size() > speeds)
    return sentence({"there are ", several(c.size(), "constraint", " on the velocities").view(), " for ",
                     several(speeds, m.derived_by == method::kane ? "speed" : "coordinate").view(),
                     advice_on_redundant(m, configuration, c).view()});
  if (const sentence found = detail::check_velocities(s, c, configuration, by_u)) return found;
  if (const sentence found = detail::check_slopes(s, c, configuration)) return found;
  if (const sentence contradiction = detail::check_repeated_rates(s, c, configuration)) return contradiction;
  if (c.size() == speeds && speeds > 0)
    return sentence({"the constraints determine every ", a_speed(m), ", so nothing can move",
                     advice_on_redundant(m, configuration, c).view()});
  return {};
}

namespace detail {

/// Whether the rows can be solved for the given columns in some configuration.
constexpr bool can_be_solved(const sequence<numbers>& states, const sequence<int>& columns) {
  sequence<numbers> chosen;
  for (const numbers& state : states) {
    numbers part{state.rows, columns.size(), {}};
    for (int i = 0; i < state.rows; ++i)
      for (int j : columns) part.entries.push(state(i, j));
    chosen.push(part);
  }
  return !independent_rows(equilibrated(chosen), columns.size()).contains(0);
}

} // namespace detail

/// Checks the dependent speeds and coordinates chosen by the user; `by_q` and `by_u` are as above.
constexpr sentence check_choice(const mechanism& m, const given_constraints& given, const constraints& c,
                                const symbolic::matrix& configuration, const sequence<numbers>& by_q,
                                const sequence<numbers>& by_u) {
  for (int j : given.dependent_speeds) {
    if (detail::has_entry_in_column(c.jacobian, j)) continue;
    return sentence(
        {"dependent ", speed_called(m, called(m, m.speeds[j])).view(), " appears in no constraint"});
  }
  for (int j : given.dependent_coordinates) {
    if (detail::has_entry_in_column(configuration, j)) continue;
    return sentence(
        {"dependent coordinate ", called(m, m.coordinates[j]), " appears in no configuration constraint"});
  }
  const int bound = given.dependent_speeds.size(), placed = given.dependent_coordinates.size();
  if (bound != 0 && bound != c.size())
    return sentence(
        {several(bound, m.derived_by == method::kane ? "dependent speed" : "dependent rate").view(), " for ",
         several(c.size(), "constraint", " on the velocities").view(), "; the numbers must be equal"});
  if (placed != 0 && placed != configuration.rows)
    return sentence({several(placed, "dependent coordinate").view(), " for ",
                     several(configuration.rows, "configuration constraint").view(),
                     "; the numbers must be equal"});
  if (bound != 0 && !detail::can_be_solved(by_u, given.dependent_speeds))
    return sentence({"the constraints cannot be solved for the dependent ",
                     speeds_called(m, given.dependent_speeds).view(), " in any configuration"});
  if (placed != 0 && !detail::can_be_solved(by_q, given.dependent_coordinates))
    return sentence({"the configuration constraints cannot be solved for the dependent ",
                     enumerated(m, m.coordinates, given.dependent_coordinates, "coordinate").view(),
                     " in any configuration"});
  return {};
}

} // namespace kanexpr::mechanics
