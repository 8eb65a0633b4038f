#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/vector.hpp>
#include <kanexpr/mechanics/model/wording.hpp>
#include <kanexpr/mechanics/units/deformation_amplitudes.hpp>
#include <kanexpr/mechanics/units/unit_relations.hpp>
#include <kanexpr/symbolic/graph/composition.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/function_table.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/list.hpp>
#include <kanexpr/symbolic/graph/live_nodes.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>
#include <kanexpr/symbolic/printing/short_text.hpp>
#include <kanexpr/units/possible_unit.hpp>
#include <kanexpr/units/si.hpp>
#include <kanexpr/units/unit.hpp>
#include <kanexpr/units/unit_text.hpp>

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

  constexpr const sentence& mistake() const { return mistake_; }

  /// The unit of an expression; none if it is not determined. Sums of different units are not reported.
  constexpr units::possible_unit unit_of(expression e) {
    const sentence before = mistake_;
    unit_product u = relations_.resolved(of(e));
    mistake_ = before;
    if (u.fits_all || !u.is_known() || relations_.is_rounded(u.known)) return {};
    const bool is_inferred = !form_at(e.node()).is_known();
    if (is_inferred && g_[e.node()].op == operation::symbol) unit_relations::drop_angle_of_length(u.known);
    return u.known;
  }

  /// Reports a sum of different units in an expression of the part described last. `unit_of` would hide it,
  /// because the unit of an expression is found only once.
  constexpr void examine(expression e) {
    if (!mistake_) of(e);
  }

  /// Names the part of the model that the next expressions describe: {"the force at ", "P"}.
  constexpr void describe(std::initializer_list<std::string_view> subject) {
    composed_ = sentence(subject);
    describe(composed_.view(), {});
  }
  /// The same with texts that outlive the description: "the mass of " and "B". No sentence is composed,
  /// because most parts have no mistake.
  constexpr void describe(std::string_view what, std::string_view whose) {
    what_ = what, whose_ = whose;
    ++described_;
  }

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
    if (mistake_ || !e.is_given() || !holds_parameter(e)) return;
    const unit_product found = of(e);
    if (!mistake_) equate(found, known_unit(u));
    mistake_ = {};
  }
  /// The same for the coefficient of the square of a rate in an energy or a power.
  constexpr void suggest_coefficient(expression e, expression rate, const units::unit& u) {
    if (mistake_ || !e.is_given() || !holds_parameter(e)) return;
    const unit_product coefficient = of(e), velocity = of(rate);
    const unit_product found = relations_.product(relations_.product(coefficient, velocity), velocity);
    if (!mistake_) equate(found, known_unit(u));
    mistake_ = {};
  }
  /// The same for a deformation, which is proportional to an amplitude.
  constexpr void suggest_amplitude(expression e, const units::unit& u) {
    if (mistake_) return;
    const unit_product found = relations_.resolved(of(e));
    if (found.unknowns == 1 && relations_.unknown(found, 0).power == units::unit::parts)
      equate(found, known_unit(u));
    mistake_ = {};
  }
  /// States that an expression is formed from quantities of one unit, whatever it is; it is the difference of
  /// the sides of an equation.
  constexpr void expect_equation(expression difference) {
    if (mistake_) return;
    const symbolic::node& n = g_[difference.node()];
    if (n.op != symbolic::operation::subtract) {
      of(difference);
      return;
    }
    const unit_product left = of(n.a), right = of(n.b);
    if (!mistake_ && !equate(left, right)) fail_by_pair({" equates ", " and "}, n.a, left, n.b, right);
  }

private:
  using operation = symbolic::operation;

  constexpr void state(const stated_unit& s) {
    const int id = s.symbol.node();
    if (!s.unit.is_in_range())
      return fail({"the unit stated for ", name_of(s.symbol),
                   " is out of range; its powers must be multiples of 1/60 between -273 and 273"});
    if (!has_form(id)) return set_form(id, known_unit(s.unit));
    const units::unit& before = form_at(id).known;
    if (!(before == s.unit))
      fail({"two units are stated for ", name_of(s.symbol), ": ", text_of(before).view(), " and ",
            text_of(s.unit).view()});
  }

  constexpr bool holds_parameter(expression e) const {
    const sequence<char> live = symbolic::live_nodes(g_, {e.node()});
    for (int id = 0; id < live.size(); ++id)
      if (live[id] != 0 && g_[id].op == operation::symbol &&
          g_.symbol_at(id).kind == symbolic::symbol_kind::parameter)
        return true;
    return false;
  }

  constexpr std::string_view name_of(expression symbol) const {
    return g_.symbol_at(symbol.node()).called.view();
  }
  static constexpr base::name text_of(const units::unit& u) {
    return units::text_of(u, units::spelling::message);
  }

  constexpr void fail(std::initializer_list<std::string_view> pieces) {
    if (!mistake_) mistake_ = sentence(pieces);
  }

  /// Adds an equation between units, and records what it describes if it determines one.
  constexpr bool equate(const unit_product& a, const unit_product& b) {
    const bool fits = relations_.equate(a, b);
    const int solved = relations_.last_solved();
    if (solved == none) return fits;
    if (reason_of_.size() < relations_.size()) reason_of_.resize(relations_.size(), none);
    if (reason_described_ != described_) reasons_.push(sentence({what_, whose_}));
    reason_described_ = described_;
    reason_of_[solved] = reasons_.size() - 1;
    return fits;
  }

  constexpr void require(expression e, const unit_product& wanted) {
    if (mistake_ || !e.is_given()) return;
    const unit_product found = of(e);
    if (!mistake_ && !equate(found, wanted)) fail_by_unit(e.node(), found, relations_.resolved(wanted).known);
  }

  constexpr void fail_by_unit(int id, const unit_product& found, const units::unit& wanted) {
    const bool is_number = wanted == units::dimensionless;
    fail({what_, whose_, " is ", with_unit(id, found).view(),
          is_number ? ", but must be a number" : ", but must be in ", is_number ? "" : text_of(wanted).view(),
          origin_of_unit(id).view()});
  }

  /// An expression with its unit in brackets; without one if its unit is not known.
  constexpr sentence with_unit(int id, const unit_product& u) {
    const unit_product found = relations_.resolved(u);
    const symbolic::short_text text(g_, id);
    if (!found.is_known()) return sentence({text.view()});
    return sentence({text.view(), " [", text_of(found.known).view(), "]"});
  }

  /// The words before and between two quantities.
  struct wording {
    std::string_view before, between;
  };
  constexpr void fail_by_pair(const wording& how, int a, const unit_product& left, int b,
                              const unit_product& right) {
    const unit_product ratio = relations_.resolved(relations_.quotient(right, left));
    const bool are_known = relations_.resolved(left).is_known();
    fail({what_, whose_, how.before, with_unit(a, left).view(), how.between, with_unit(b, right).view(),
          are_known ? "" : ", whose units differ by a factor of ",
          are_known ? "" : text_of(ratio.known).view(), origin_of_unit(b, a).view()});
  }

  /// Explains a unit: "; the factor 0.3 has no unit" if an expression has a factor that may be meant to have
  /// one, otherwise the unit of the first parameter or input whose unit the model does not state: "; c is in
  /// N s/m by the force at P". Empty if there is none, or if the present part of the model determines it.
  constexpr sentence origin_of_unit(int id, int other = symbolic::graph::zero) {
    for (const int each : {id, other})
      if (const int factor = factor_in(each); factor != none)
        return sentence({"; the factor ", symbolic::short_text(g_, factor).view(), " has no unit"});
    const sentence found = origin_in(id);
    return found ? found : origin_in(other);
  }
  /// The first number among the factors of a product, except ratios such as 1/2 and small integers.
  constexpr int factor_in(int id) const {
    const symbolic::node& n = g_[id];
    if (n.op == operation::negate) return factor_in(n.a);
    if (n.op == operation::divide) return factor_in(n.a);
    if (n.op == operation::multiply) {
      const int found = factor_in(n.a);
      return found != none ? found : factor_in(n.b);
    }
    if (n.op != operation::constant) return none;
    const symbolic::number& value = g_.number_at(id);
    if (value.exact() && value.numerator < 5 && value.numerator > -5) return none;
    return id;
  }
  constexpr sentence origin_in(int id) {
    const symbolic::node& n = g_[id];
    if (n.op == operation::constant) return {};
    if (n.op != operation::symbol) {
      sentence found = origin_in(n.a);
      if (!found && symbolic::is_binary(n.op) && !symbolic::has_index_operand(n.op)) found = origin_in(n.b);
      return found;
    }
    const symbolic::symbol_kind kind = g_.symbol_at(id).kind;
    if (kind != symbolic::symbol_kind::parameter && kind != symbolic::symbol_kind::input) return {};
    if (!has_form(id) || form_at(id).unknowns != 1) return {};
    const int unknown = relations_.unknown(form_at(id), 0).of;
    if (!relations_.is_solved(unknown) || unknown >= reason_of_.size() || reason_of_[unknown] == none)
      return {};
    const std::string_view reason = reasons_[reason_of_[unknown]].view();
    const unit_product u = relations_.resolved(form_at(id));
    if (reason.empty() || reason == sentence({what_, whose_}).view() || !u.is_known()) return {};
    return sentence(
        {"; ", g_.symbol_at(id).called.view(), " is in ", text_of(u.known).view(), " by ", reason});
  }

  constexpr bool has_form(int id) const { return id < place_of_form_.size() && place_of_form_[id] != none; }
  /// The form of a node that has one.
  constexpr const unit_product& form_at(int id) const { return forms_[place_of_form_[id]]; }
  constexpr void set_form(int id, const unit_product& form) {
    if (id >= place_of_form_.size()) place_of_form_.resize(g_.size(), none);
    place_of_form_[id] = forms_.push(form);
  }

  constexpr unit_product of(expression e) { return of(e.node()); }
  constexpr unit_product of(int id) {
    if (!has_form(id)) set_form(id, found_for(id, g_[id]));
    return form_at(id);
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
  constexpr unit_product of_operands(const wording& how, const sequence<expression>& operands,
                                     int first = 0) {
    int known = first; // the first operand that is not a number
    unit_product found = of(operands[known]);
    for (int i = first + 1; i < operands.size(); ++i) {
      const unit_product other = of(operands[i]);
      if (!equate(found, other)) fail_by_pair(how, operands[known].node(), found, operands[i].node(), other);
      if (found.fits_all && !other.fits_all) known = i, found = other;
    }
    return found;
  }

  /// The unit of a sum or difference: that of both operands.
  constexpr unit_product of_pair(const wording& how, const symbolic::node& n) {
    const unit_product left = of(n.a), right = of(n.b);
    if (!equate(left, right)) fail_by_pair(how, n.a, left, n.b, right);
    return left.fits_all ? right : left;
  }

  /// The condition of a selection, whose sign is that of a difference: max(a, b) compares a and b.
  constexpr void compare(int condition) {
    const symbolic::node& n = g_[condition];
    if (!has_form(condition) && n.op == operation::subtract) of_pair({" compares ", " and "}, n);
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
    if (equate(of(id), known_unit(u))) return;
    fail({what_, whose_, " contains ", symbolic::short_text(g_, function).view(), "; ",
          with_unit(id, of(id)).view(), u == units::si::radian ? " is not an angle" : " is not a number",
          origin_of_unit(id).view()});
  }

  const mechanism& m_;
  const symbolic::graph& g_;
  unit_relations relations_{};
  deformation_amplitudes amplitudes_{};
  sequence<unit_product> forms_{};
  sequence<int> place_of_form_{};     ///< by node
  std::string_view what_{}, whose_{}; ///< the part of the model that is described
  sentence composed_{}, mistake_{};
  int described_ = 0,
      reason_described_ = 0;     ///< numbers of descriptions: the present one, that of the last reason
  sequence<sentence> reasons_{}; ///< the parts of the model that determine units
  sequence<int> reason_of_{};    ///< by unknown unit
};

} // namespace kanexpr::mechanics
