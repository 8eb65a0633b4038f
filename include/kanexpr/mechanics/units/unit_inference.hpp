#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/vector.hpp>
#include <kanexpr/mechanics/model/wording.hpp>
#include <kanexpr/mechanics/units/deformation_amplitudes.hpp>
#include <kanexpr/mechanics/units/unit_relations.hpp>
#include <kanexpr/mechanics/units/unit_sentences.hpp>
#include <kanexpr/symbolic/graph/composition.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/function_table.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/list.hpp>
#include <kanexpr/symbolic/graph/live_nodes.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>
#include <kanexpr/units/possible_unit.hpp>
#include <kanexpr/units/si.hpp>
#include <kanexpr/units/unit.hpp>

#include <cstdint>
#include <initializer_list>
#include <string_view>

namespace kanexpr::mechanics {

/// Infers the units of expressions from the units that a mechanism states for its symbols.
///
/// Each symbol without a stated unit has an unknown one. Sums, function arguments and the units that `expect`
/// states are equations between units, which are solved as they come; the first that has no solution is the
/// mistake. A number that is a factor has no unit. A number that is a term, an argument or a whole quantity
/// has the unit that is expected there.
class unit_inference {
public:
  constexpr explicit unit_inference(const mechanism& m) : m_(m), g_(*m.g) {}

  /// Takes the units that the mechanism states, first of all.
  constexpr void take_stated_units() {
    amplitudes_.mark(m_);
    for (const stated_unit& each : m_.stated_units) state(each);
    for (const prescribed_rate& p : m_.prescribed_rates) {
      const unit_product quantity = of(p.quantity);
      require(p.rate, relations_.quotient(quantity, known_unit(units::si::second)));
    }
  }

  unit_inference(const unit_inference&) = delete;
  unit_inference& operator=(const unit_inference&) = delete;

  constexpr const sentence& mistake() const { return words_.mistake(); }

  /// The unit of an expression; none if it is not determined. Sums of different units are not reported.
  constexpr units::possible_unit unit_of(expression e) {
    const sentence before = mistake();
    unit_product u = relations_.resolved(of(e));
    words_.set_mistake(before);
    if (u.fits_all || !u.is_known() || relations_.is_rounded(u.known)) return {};
    const bool is_inferred = !forms_[e.node()].is_known();
    if (is_inferred && g_[e.node()].op == operation::symbol) unit_relations::drop_angle_of_length(u.known);
    return u.known;
  }

  /// Reports a sum of different units in an expression of the part described last. `unit_of` would hide it,
  /// because the unit of an expression is found only once.
  constexpr void examine(expression e) {
    if (!mistake()) of(e);
  }

  /// Names the part of the model that the next expressions describe: {"the force at ", "P"}.
  constexpr void describe(std::initializer_list<std::string_view> subject) { words_.describe(subject); }
  /// The same with texts that outlive the description: "the mass of " and "B". No sentence is composed,
  /// because most parts have no mistake.
  constexpr void describe(std::string_view what, std::string_view whose) { words_.describe(what, whose); }

  /// States the unit of a quantity of the part described last.
  constexpr void expect(expression e, const units::unit& u) { require(e, known_unit(u)); }
  constexpr void expect(const vector& v, const units::unit& u) {
    v.each_entry([&](expression e) { expect(e, u); });
  }
  constexpr void expect(const dyadic& d, const units::unit& u) {
    d.each_entry([&](expression e) { expect(e, u); });
  }
  /// States the unit of a quantity whose numbers may have units; a contradiction is no mistake. It has no
  /// effect if the quantity contains no parameter, because its coefficients are then such numbers.
  constexpr void suggest(expression e, const units::unit& u) {
    if (mistake() || !e.is_given() || !holds_parameter(e)) return;
    const unit_product found = of(e);
    if (!mistake()) equate(found, known_unit(u));
    words_.set_mistake({});
  }
  /// The same for the coefficient of the square of a rate in an energy or a power.
  constexpr void suggest_coefficient(expression e, expression rate, const units::unit& u) {
    if (mistake() || !e.is_given() || !holds_parameter(e)) return;
    const unit_product coefficient = of(e), velocity = of(rate);
    const unit_product found = relations_.product(relations_.product(coefficient, velocity), velocity);
    if (!mistake()) equate(found, known_unit(u));
    words_.set_mistake({});
  }
  /// The same for a deformation, which is proportional to an amplitude.
  constexpr void suggest_amplitude(expression e, const units::unit& u) {
    if (mistake()) return;
    const unit_product found = relations_.resolved(of(e));
    if (found.unknowns == 1 && relations_.unknown(found, 0).power == units::unit::parts)
      equate(found, known_unit(u));
    words_.set_mistake({});
  }
  /// States that an expression is formed from quantities of one unit, whatever it is; it is the difference of
  /// the sides of an equation.
  constexpr void expect_equation(expression difference) {
    if (mistake()) return;
    const symbolic::node& n = g_[difference.node()];
    if (n.op != symbolic::operation::subtract) {
      of(difference);
      return;
    }
    const unit_product left = of(n.a), right = of(n.b);
    if (!mistake() && !equate(left, right))
      words_.fail_by_pair({" equates ", " and "}, n.a, left, n.b, right);
  }

private:
  using operation = symbolic::operation;

  constexpr void state(const stated_unit& s) {
    const int id = s.symbol.node();
    if (!s.unit.is_in_range())
      return words_.fail({"the unit stated for ", name_of(s.symbol),
                          " is out of range; its powers must be multiples of 1/60 between -273 and 273"});
    if (!forms_.has(id)) return forms_.set(id, known_unit(s.unit), g_.size());
    const units::unit& before = forms_[id].known;
    if (!(before == s.unit))
      words_.fail({"two units are stated for ", name_of(s.symbol), ": ",
                   unit_sentences::text_of(before).view(), " and ", unit_sentences::text_of(s.unit).view()});
  }

  constexpr bool holds_parameter(expression e) const {
    const base::zeros<char> live = symbolic::live_nodes(g_, {e.node()});
    for (int id = 0; id < live.size(); ++id)
      if (live[id] != 0 && g_[id].op == operation::symbol &&
          g_.symbol_at(id).kind == symbolic::symbol_kind::parameter)
        return true;
    return false;
  }

  constexpr std::string_view name_of(expression symbol) const {
    return g_.symbol_at(symbol.node()).called.view();
  }

  /// Adds an equation between units, and records what it describes if it determines one.
  constexpr bool equate(const unit_product& a, const unit_product& b) {
    const bool fits = relations_.equate(a, b);
    const int solved = relations_.last_solved();
    if (solved != none) words_.note_solved(solved);
    return fits;
  }

  constexpr void require(expression e, const unit_product& wanted) {
    if (mistake() || !e.is_given()) return;
    const unit_product found = of(e);
    if (!mistake() && !equate(found, wanted))
      words_.fail_by_unit(e.node(), found, relations_.resolved(wanted).known);
  }

  constexpr unit_product of(expression e) { return of(e.node()); }
  constexpr unit_product of(int id) {
    if (!forms_.has(id)) forms_.set(id, found_for(id, g_[id]), g_.size());
    return forms_[id];
  }

  constexpr unit_product found_for(int id, const symbolic::node& n) {
    using symbolic::form;
    switch (symbolic::form_of(n.op)) {
    case form::leaf: return of_leaf(id, n);
    case form::negate: return of(n.a);
    case form::add: return of_pair({" adds ", " and "}, n);
    case form::subtract: return of_pair({" subtracts ", " from "}, {n.op, n.b, n.a});
    case form::multiply: return of_product(n, 1);
    case form::divide: return of_product(n, -1);
    case form::power: return of_power(id, n);
    case form::function: return of_function(id, n);
    case form::binary_function: return of_binary_function(id, n);
    case form::selection: compare(n.a); return of(n.b);
    case form::list_operation: break;
    }
    if (n.op == operation::call)
      for (const int operand : symbolic::elements_of(g_, n.a)) of(operand);
    return relations_.add_unknown();
  }

  constexpr unit_product of_leaf(int id, const symbolic::node& n) {
    if (n.op == operation::constant) return unit_of_number;
    using symbolic::symbol_kind;
    const symbolic::symbol& s = g_.symbol_at(id);
    switch (s.kind) {
    case symbol_kind::time: return known_unit(units::si::second);
    case symbol_kind::coordinate_rate: return rate_of(m_.coordinates[s.position]);
    case symbol_kind::speed_rate: return rate_of(m_.speeds[s.position]);
    case symbol_kind::coordinate:
    case symbol_kind::speed:
    case symbol_kind::parameter:
    case symbol_kind::input:
    case symbol_kind::auxiliary_speed:
    case symbol_kind::multiplier:
    case symbol_kind::weight:
    case symbol_kind::direction: break;
    }
    for (const stated_unit& each : m_.stated_units) // a symbol may be added later
      if (each.symbol.node() == id) return known_unit(each.unit);
    for (const function_value& each : m_.function_values)
      if (each.symbol.node() == id) return of_value(each);
    return relations_.add_unknown();
  }

  constexpr unit_product rate_of(expression symbol) {
    return relations_.quotient(of(symbol), known_unit(units::si::second));
  }

  constexpr unit_product of_value(const function_value& f) {
    using symbolic::composition;
    switch (f.function) {
    case composition::hypot: return of_operands({" takes the hypot of ", " and "}, f.operands);
    case composition::if_positive: {
      compare(f.operands[0].node());
      return of_operands({" selects ", " or "}, f.operands, 1);
    }
    case composition::min:
    case composition::max:
    case composition::clamp:
    case composition::smooth_abs:
    case composition::softplus: return of_operands({" compares ", " and "}, f.operands);
    case composition::smooth_step: of_operands({" compares ", " and "}, f.operands); return known_unit({});
    case composition::tabulated:
    case composition::periodic: break; // their values may have any unit
    }
    return relations_.add_unknown();
  }
  /// The unit that all operands from the given one on have.
  constexpr unit_product of_operands(const unit_sentences::wording& how, const sequence<expression>& operands,
                                     int first = 0) {
    int known = first; // the first operand that is not a number
    unit_product found = of(operands[known]);
    for (int i = first + 1; i < operands.size(); ++i) {
      const unit_product other = of(operands[i]);
      if (!equate(found, other))
        words_.fail_by_pair(how, operands[known].node(), found, operands[i].node(), other);
      if (found.fits_all && !other.fits_all) known = i, found = other;
    }
    return found;
  }

  /// The unit of a sum or difference: that of both operands.
  constexpr unit_product of_pair(const unit_sentences::wording& how, const symbolic::node& n) {
    const unit_product left = of(n.a), right = of(n.b);
    if (!equate(left, right)) words_.fail_by_pair(how, n.a, left, n.b, right);
    return left.fits_all ? right : left;
  }

  /// The condition of a selection, whose sign is that of a difference: max(a, b) compares a and b.
  constexpr void compare(int condition) {
    const symbolic::node& n = g_[condition];
    if (!forms_.has(condition) && n.op == operation::subtract) of_pair({" compares ", " and "}, n);
    of(condition);
  }

  constexpr unit_product of_product(const symbolic::node& n, int sign) {
    unit_product left = of(n.a), right = of(n.b);
    if (left.fits_all && right.fits_all) return left;
    if (left.fits_all != right.fits_all && amplitudes_.form(g_, left.fits_all ? n.b : n.a))
      return relations_.add_unknown();
    return sign > 0 ? relations_.product(left, right) : relations_.quotient(left, right);
  }

  constexpr unit_product of_power(int id, const symbolic::node& n) {
    unit_product base = of(n.a);
    of(n.b);
    if (!g_.is_constant(n.b)) {
      argument_is(id, n.a, {});
      argument_is(id, n.b, {});
      return known_unit({});
    }
    if (base.fits_all) return base;
    const symbolic::number& exponent = g_.number_at(n.b);
    constexpr std::int64_t parts = units::unit::parts;
    const double scaled = exponent.value() * static_cast<double>(parts);
    if (scaled < 30'000 && scaled > -30'000) {
      const auto whole = static_cast<std::int64_t>(scaled < 0 ? scaled - 0.5 : scaled + 0.5);
      const double rest = scaled - static_cast<double>(whole);
      if (rest > 1e-9 || rest < -1e-9) relations_.tolerate_rounding();
      if (relations_.has_power(base, whole, parts)) return relations_.power(base, whole, parts);
    }
    if (base.is_known() && base.known == units::dimensionless) return base;
    return relations_.add_unknown();
  }

  constexpr unit_product of_function(int id, const symbolic::node& n) {
    using symbolic::unit_rule;
    unit_product argument = of(n.a);
    switch (symbolic::properties_of(n.op).unit) {
    case unit_rule::numbers: return of_numbers(id, n, symbolic::properties_of(n.op).angle);
    case unit_rule::kept: return argument;
    case unit_rule::root: return root_of(argument, 2);
    case unit_rule::cube_root: return root_of(argument, 3);
    case unit_rule::dropped: break;
    }
    return known_unit({});
  }
  constexpr unit_product of_numbers(int id, const symbolic::node& n, symbolic::angle_rule angle) {
    using symbolic::angle_rule;
    const auto radian_if = [&](angle_rule is) {
      return angle == is || angle == angle_rule::both ? units::si::radian : units::dimensionless;
    };
    argument_is(id, n.a, radian_if(angle_rule::argument));
    return known_unit(radian_if(angle_rule::value));
  }
  constexpr unit_product root_of(const unit_product& u, int order) {
    if (u.fits_all || relations_.has_power(u, 1, order)) return relations_.power(u, 1, order);
    return relations_.add_unknown();
  }

  constexpr unit_product of_binary_function(int id, const symbolic::node& n) {
    using symbolic::binary_unit_rule;
    switch (symbolic::binary_properties_of(n.op).unit) {
    case binary_unit_rule::numbers:
      argument_is(id, n.a, {});
      argument_is(id, n.b, {});
      break;
    case binary_unit_rule::ratio:
      of_pair({" takes the atan2 of ", " and "}, n);
      return known_unit(units::si::radian);
    case binary_unit_rule::kept: return of_pair({" compares ", " and "}, n);
    }
    return known_unit({});
  }

  /// States the unit of the argument of a function.
  constexpr void argument_is(int function, int id, const units::unit& u) {
    if (!equate(of(id), known_unit(u))) words_.fail_by_argument(function, id, of(id), u == units::si::radian);
  }

  const mechanism& m_;
  const symbolic::graph& g_;
  unit_relations relations_{};
  deformation_amplitudes amplitudes_{};
  unit_forms forms_{};
  unit_sentences words_{g_, relations_, forms_};
};

} // namespace kanexpr::mechanics
