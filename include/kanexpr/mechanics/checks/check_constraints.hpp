#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/checks/linearity.hpp>
#include <kanexpr/mechanics/checks/prescribed.hpp>
#include <kanexpr/mechanics/checks/repeated_constraints.hpp>
#include <kanexpr/mechanics/constraints/consistent_states.hpp>
#include <kanexpr/mechanics/constraints/dependent_speeds.hpp>
#include <kanexpr/mechanics/model/contents.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/wording.hpp>
#include <kanexpr/mechanics/skeleton/skeleton.hpp>
#include <kanexpr/symbolic/derivatives/differentiate.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <string_view>

/// Checks of constraints: of their contents, of their number, and for singularity in every configuration.
namespace kanexpr::mechanics {

/// The Jacobian of the configuration constraints with respect to all coordinates.
constexpr symbolic::matrix configuration_jacobian_by_all(const mechanism& m,
                                                         const sequence<expression>& constraints) {
  symbolic::matrix jacobian(*m.g, constraints.size(), m.coordinates.size());
  for (int j = 0; j < jacobian.columns && jacobian.rows > 0; ++j) {
    symbolic::differentiation by_coordinate(*m.g);
    by_coordinate.set_rate(m.coordinates[j], m.one());
    for (int i = 0; i < jacobian.rows; ++i) jacobian(i, j) = by_coordinate.of(constraints[i]);
  }
  return jacobian;
}

/// Reports configuration constraints that vanish identically, as they do for planar loops modeled in space.
constexpr sentence constraints_of_nothing(const given_constraints& given) {
  sequence<int> numbers;
  for (int i = 0; i < given.on_configuration.size(); ++i)
    if (given.on_configuration[i].is_zero() && !given.redundant.contains(i + 1)) numbers.push(i + 1);
  return dropping(numbers, " contains no coordinate", " contain no coordinate");
}

/// Checks which symbols the constraints of a model contain.
constexpr sentence check_contents_of_constraints(const mechanism& m, const given_constraints& given) {
  using kind = symbolic::symbol_kind;
  if (given.on_configuration.empty() && given.on_velocities.empty() && given.on_accelerations.empty())
    return {};
  const contents held(*m.g);
  for (int i = 0; i < given.on_configuration.size(); ++i) {
    const expression f = given.on_configuration[i];
    const name which = base::counted(i + 1);
    struct named_kind {
      kind what;
      std::string_view called;
    };
    if (held.holds(f, kind::speed))
      return sentence({"configuration constraint ", which.view(), " contains the ",
                       speed_called(m, held.name_of(f, kind::speed)).view(),
                       "; it may contain only coordinates"});
    if (held.holds(f, kind::speed_rate))
      return sentence({"configuration constraint ", which.view(), " contains the ",
                       speed_rate_called(m, held.name_of(f, kind::speed_rate)).view(),
                       "; it may contain only coordinates"});
    for (const named_kind& w : {named_kind{kind::auxiliary_speed, " contains the auxiliary speed "},
                                named_kind{kind::coordinate_rate, " contains the rate of coordinate "}})
      if (held.holds(f, w.what))
        return sentence({"configuration constraint ", which.view(), w.called, held.name_of(f, w.what),
                         "; it may contain only coordinates"});
    if (const unknown_derivative u = find_unknown_derivative(m, held, f, 2))
      return sentence({"configuration constraint ", which.view(), " contains the input ", u.input, ", whose ",
                       u.what, is_not_known});
    if (!held.holds(f, kind::coordinate) && !given.redundant.contains(i + 1))
      return f.is_zero() ? constraints_of_nothing(given)
                         : sentence({"configuration constraint ", which.view(), " contains no coordinate"});
  }
  for (int i = 0; i < given.on_velocities.size(); ++i) {
    const expression v = given.on_velocities[i].value;
    const name which = base::counted(i + 1);
    if (held.holds(v, kind::speed_rate))
      return sentence({"velocity constraint ", which.view(), " contains the ",
                       speed_rate_called(m, held.name_of(v, kind::speed_rate)).view()});
    if (const unknown_derivative u = find_unknown_derivative(m, held, v, 1))
      return sentence({"velocity constraint ", which.view(), " contains the input ", u.input, ", whose ",
                       u.what, is_not_known});
    if (!held.holds_any(v, {kind::speed, kind::coordinate_rate}))
      return held.holds(v, kind::coordinate)
                 ? sentence({"velocity constraint ", which.view(), " contains the coordinate ",
                             held.name_of(v, kind::coordinate), " but no ", a_speed(m),
                             "; move it to configuration_constraints<...>"})
                 : sentence({"velocity constraint ", which.view(), " contains no ", a_speed(m)});
    const sentence not_linear =
        check_linear(m, held, v, sentence({"velocity constraint ", which.view()}).view());
    if (not_linear) return not_linear;
  }
  return {};
}

namespace detail {

/// Whether a configuration constraint whose gradient depends linearly on those of the preceding ones is
/// violated wherever the preceding ones hold.
constexpr bool contradicts_configuration(const skeleton& s, const constraints& c,
                                         const symbolic::matrix& configuration, int i) {
  const sequence<expression> last{c.on_configuration[i]};
  consistent_states states(s, configuration, i, c, 0, last);
  return first_that_never_vanishes(states, last) == 0;
}

/// The same for a velocity constraint.
constexpr bool contradicts_velocities(const skeleton& s, const constraints& c,
                                      const symbolic::matrix& configuration, int i) {
  const sequence<expression> last{c.on_velocities[i].value};
  consistent_states states(s, configuration, configuration.rows, c, i, last);
  return first_that_never_vanishes(states, last) == 0;
}

/// Checks the rates of configuration constraints that are omitted because velocity constraints imply them.
constexpr sentence check_repeated_rates(const skeleton& s, const constraints& c,
                                        const symbolic::matrix& configuration) {
  if (c.repeated.empty()) return {};
  consistent_states anywhere(s, configuration, 0, c, c.size(), c.repeated);
  if (first_that_never_vanishes(anywhere, c.repeated) == none)
    return {}; // true in any configuration, as it is for most models
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

} // namespace detail

/// Reports constraints that leave no motion, follow from the preceding ones, or contradict them. `by_q` and
/// `by_u` are the Jacobians of the configuration constraints and of the constraints on the speeds,
/// equilibrated, at generic states.
constexpr sentence check_constraints(const skeleton& s, const constraints& c,
                                     const symbolic::matrix& configuration, const sequence<numbers>& by_q,
                                     const sequence<numbers>& by_u) {
  const mechanism& m = *s.model;
  const int speeds = m.speeds.size(), coordinates = m.coordinates.size();
  if (configuration.rows > coordinates)
    return sentence({"there are ", several(configuration.rows, "configuration constraint").view(), " for ",
                     several(coordinates, "coordinate").view(),
                     advice_on_redundant(m, configuration, c).view()});
  const sequence<char> holds = independent_rows(by_q, configuration.rows);
  for (int i = 0; i < configuration.rows; ++i)
    if (holds[i] == 0)
      return i == 0 || detail::contradicts_configuration(s, c, configuration, i)
                 ? sentence({"configuration constraint ", base::counted(c.numbers[i]).view(),
                             i == 0 ? " constrains no coordinate in any configuration"
                                    : " contradicts the preceding ones"})
                 : dropping({c.numbers[i]}, " follows from the preceding ones in every configuration", {});
  for (int i = 0; i < c.size(); ++i) {
    bool moves = false;
    for (int j = 0; j < speeds; ++j) moves = moves || !c.jacobian(i, j).is_zero();
    if (moves) continue;
    if (c.of_configuration[i] == none)
      return sentence({"velocity constraint ", base::counted(i + 1).view(), " contains no ", a_speed(m)});
    return sentence({"the rate of configuration constraint ",
                     base::counted(c.numbers[c.of_configuration[i]]).view(), " contains no ", a_speed(m)});
  }
  if (c.size() > speeds)
    return sentence({"there are ", several(c.size(), "constraint", " on the velocities").view(), " for ",
                     several(speeds, m.derived_by == method::kane ? "speed" : "coordinate").view(),
                     advice_on_redundant(m, configuration, c).view()});
  const sequence<char> binds = independent_rows(by_u, c.size());
  for (int i = 0; i < c.size(); ++i) {
    if (binds[i] != 0) continue;
    const bool is_false = i > 0 && detail::contradicts_velocities(s, c, configuration, i);
    if (c.of_configuration[i] == none)
      return sentence({"velocity constraint ", base::counted(i + 1).view(),
                       i == 0     ? " constrains no "
                       : is_false ? " contradicts the preceding ones"
                                  : " follows from the preceding ones in every configuration",
                       i == 0 ? a_speed(m) : "", i == 0 ? " in any configuration" : ""});
    return sentence({"the rate of configuration constraint ",
                     base::counted(c.numbers[c.of_configuration[i]]).view(),
                     is_false ? " contradicts the other constraints"
                              : " follows from the other constraints in every configuration"});
  }
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
  for (char independent : independent_rows(equilibrated(chosen), columns.size()))
    if (independent == 0) return false;
  return true;
}

} // namespace detail

/// Checks the dependent speeds and coordinates chosen by the user; `by_q` and `by_u` are as above.
constexpr sentence check_choice(const mechanism& m, const given_constraints& given, const constraints& c,
                                const symbolic::matrix& configuration, const sequence<numbers>& by_q,
                                const sequence<numbers>& by_u) {
  for (int j : given.dependent_speeds) {
    bool appears = false;
    for (int i = 0; i < c.size(); ++i) appears = appears || !c.jacobian(i, j).is_zero();
    if (!appears)
      return sentence(
          {"dependent ", speed_called(m, called(m, m.speeds[j])).view(), " appears in no constraint"});
  }
  for (int j : given.dependent_coordinates) {
    bool appears = false;
    for (int i = 0; i < configuration.rows; ++i) appears = appears || !configuration(i, j).is_zero();
    if (!appears)
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
