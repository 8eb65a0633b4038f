#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/derivation/read/entity_reader.hpp>
#include <kanexpr/describe/constraint.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <string_view>

namespace kanexpr::derivation {

using mechanics::velocity_constraint;

/// Reads the constraints of a model. Their symbols and entities are read together with all others; the
/// constraints themselves are evaluated once positions and velocities are known.
class constraint_reader : part_reader {
public:
  using part_reader::part_reader;

  /// Evaluates the constraints; requires that `set_known_motion` was called.
  constexpr void read_constraints() {
    for (const kind& k : kinds)
      for (const phrase& p : reading_.from.*k.list)
        if (!reading_.mistake) read_constraint(k, p);
  }

  constexpr void visit_constraints() {
    for (const kind& k : kinds)
      for (const phrase& p : reading_.from.*k.list) {
        if (reading_.mistake) return;
        if (p.kind != shape::equation && p.kind != shape::vanishing)
          return reading_.fail({k.word, "<...> contains something that is not an equation",
                                name_in(p).empty() ? "" : ", involving ", name_in(p),
                                "; write an equation or zero_along<...>"});
        if (k.list == &system_record::configuration_constraints) check_is_on_positions(p);
        mention(p, k.whom);
      }
  }

  constexpr void read_dependent(const phrase& p) {
    constexpr std::string_view whom = "dependent<...>"sv;
    const bool alone = p.size == 1 && p.tokens[0].what == describe::token_kind::symbol;
    const symbol_record* s = alone ? p.tokens[0].symbol : nullptr;
    const bool coordinate = s != nullptr && s->kind == symbolic::symbol_kind::coordinate;
    const symbolic::symbol_kind rate = reading_.takes_rates_as_speeds()
                                           ? symbolic::symbol_kind::coordinate_rate
                                           : symbolic::symbol_kind::speed;
    const bool is_state_variable = s != nullptr && s->order == describe::of_state_variable;
    if (!coordinate && (s == nullptr || s->kind != rate || is_state_variable))
      return reading_.fail({whom, " contains something that is neither a coordinate nor ",
                            reading_.takes_rates_as_speeds() ? "the rate of one" : "a speed",
                            p.size > 0 ? ", involving " : "", name_in(p)});
    const expression e = symbols_.symbol(*s, whom);
    if (reading_.mistake) return;
    const int place = coordinate ? m_.coordinates.find(e) : m_.speeds.find(e);
    sequence<int>& places = coordinate ? reading_.into.constraints.dependent_coordinates
                                       : reading_.into.constraints.dependent_speeds;
    if (place == none)
      return reading_.fail(
          {"auxiliary speed ", s->called.view(), " appears in ", whom, "; it is zero at all times"});
    if (places.contains(place))
      return reading_.fail({kind_of(*s), s->called.view(), " is listed twice in ", whom});
    places.push(place);
  }

private:
  struct kind {
    describe::listing<phrase> describe::system_record::* list;
    std::string_view word, whom;
  };
  static constexpr kind kinds[]{
      {&system_record::configuration_constraints, "configuration_constraints"sv,
       "a configuration constraint"sv},
      {&system_record::velocity_constraints, "velocity_constraints"sv, "a velocity constraint"sv},
      {&system_record::acceleration_constraints, "acceleration_constraints"sv,
       "an acceleration constraint"sv},
  };

  constexpr void read_constraint(const kind& k, const phrase& p) {
    mechanics::given_constraints& into = reading_.into.constraints;
    for (const velocity_constraint& c : zero_expressions(p, phrases_.evaluate_each(p, k.whom), k.whom))
      if (k.list == &system_record::configuration_constraints)
        into.on_configuration.push(c.value);
      else if (k.list == &system_record::velocity_constraints)
        into.on_velocities.push(c);
      else
        into.on_accelerations.push(c.value);
    if (k.list != &system_record::configuration_constraints || m_.auxiliary_speeds.empty() ||
        reading_.for_units || reading_.mistake)
      return;
    for (const velocity_constraint& c :
         zero_expressions(p, phrases_.evaluate_each_displaced(p, k.whom), k.whom))
      into.rates_by_auxiliary.push(rate_by_auxiliary(m_, c.value));
  }

  /// Reports a configuration constraint on a velocity, such as rolling; otherwise the error would concern the
  /// speeds that it contains.
  constexpr void check_is_on_positions(const phrase& p) {
    for (const describe::token& t : p) {
      const bool turns = t.what == describe::token_kind::angular_velocity;
      if (!turns && t.what != describe::token_kind::velocity) continue;
      return reading_.fail({"a configuration constraint contains the ", turns ? "angular " : "",
                            "velocity of ", turns ? t.frame->called : t.point->called,
                            "; move it to velocity_constraints<...>"});
    }
  }
  /// Returns the expressions that one constraint sets to zero: the difference of an equation's sides, or a
  /// vector's component along each direction.
  constexpr sequence<velocity_constraint> zero_expressions(const phrase& p, const sequence<value>& found,
                                                           std::string_view whom) {
    sequence<velocity_constraint> all;
    if (reading_.mistake) return all;
    if (p.kind == shape::equation) {
      if (found[0].kind != shape::scalar)
        reading_.fail({whom, " with ", name_in(p), " equates vectors; write zero_along<vector, directions>"});
      all.push({found[0].scalar, {}, {}});
      return all;
    }
    const auto fail_for = [&](std::string_view given) {
      reading_.fail({"zero_along<...> of ", whom, " with ", name_in(p), " has ", given});
    };
    if (found[0].kind != shape::vector) fail_for("a first argument that is not a vector");
    if (found.size() == 1) fail_for("no direction");
    for (int i = 1; i < found.size() && !reading_.mistake; ++i) {
      const mechanics::vector &v = found[0].vector, &direction = found[i].vector;
      if (found[i].kind != shape::vector)
        fail_for("a direction that is not a vector");
      else if (direction.is_zero())
        fail_for("a direction of zero length");
      else if (direction.parts.size() == 1) // like `dot`, but uses the same axes for all directions
        all.push({along(m_, v, direction), v, direction});
      else
        all.push({dot(m_, v, direction), v, direction});
    }
    return all;
  }
};

} // namespace kanexpr::derivation
