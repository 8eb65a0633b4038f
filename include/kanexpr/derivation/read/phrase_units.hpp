#pragma once

#include <kanexpr/base/equal.hpp>
#include <kanexpr/base/name.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/describe/load_quantities.hpp>
#include <kanexpr/describe/pathway.hpp>
#include <kanexpr/describe/record.hpp>
#include <kanexpr/mechanics/units/unit_relations.hpp>
#include <kanexpr/symbolic/graph/composition.hpp>
#include <kanexpr/symbolic/graph/function_table.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>
#include <kanexpr/symbolic/numbers/number.hpp>
#include <kanexpr/units/si.hpp>
#include <kanexpr/units/unit.hpp>

#include <cstdint>

namespace kanexpr::derivation {

using base::sequence;
using describe::phrase;
using describe::symbol_record;
using mechanics::known_unit;
using mechanics::unit_of_number;
using mechanics::unit_product;

/// Evaluates phrases with units in place of values: a vector or a dyadic has one unit, and no expression is
/// formed. Where units depend on more than tokens, they do not fit either. Every equation between units that
/// `unit_inference` would form must follow from those formed here.
class phrase_units {
public:
  /// Whether the units of all phrases fit.
  constexpr bool fit() const { return fits_ && !relations_.omits_any(); }

  /// States the unit of a phrase.
  constexpr void expect(const phrase& p, const units::unit& u) {
    if (fits_ && p.kind != describe::shape::nothing) require(unit_of(p), u);
  }
  /// Evaluates a phrase whose unit may be any.
  constexpr unit_product unit_of(const phrase& p) {
    stack_.clear();
    for (int i = 0; i < p.size && fits_; ++i) step(p, i);
    return stack_.empty() ? unit_of_number : stack_.back().unit;
  }
  /// Evaluates vectors whose components are added after products with others: numbers among components with
  /// units would then have no unit.
  constexpr unit_product unit_of_components(const phrase& p) {
    const unit_product found = unit_of(p);
    for (const operand& each : stack_)
      if (each.is_mixed) fail();
    return found;
  }
  /// States that a stiffness times the square of a displacement is an energy.
  constexpr void expect_energy(const unit_product& stiffness, const unit_product& displacement) {
    if (fits_) require(times(times(stiffness, displacement), displacement), units::si::joule);
  }
  /// States that two phrases have the same unit.
  constexpr void equate(const unit_product& a, const unit_product& b) {
    fits_ = fits_ && relations_.equate(a, b);
  }
  /// States that the second of two symbols, by their names, is the rate of the first.
  constexpr void expect_rate(const base::name& of, const base::name& rate) {
    const unit_product quantity = unit_at(place_of(of, of.length));
    equate(relations_.quotient(quantity, known_unit(second)), unit_at(place_of(rate, rate.length)));
  }
  constexpr void fail() { fits_ = false; }

private:
  using token_kind = describe::token_kind;
  static constexpr units::unit second = units::si::second, meter = units::si::meter;

  /// A value of a phrase; the rank of a scalar is 0, that of a dyadic 2.
  struct operand {
    unit_product unit{};
    int rank = 0;
    bool is_mixed = false; ///< a vector that contains numbers among components with units
  };
  /// The unit of a symbol or of its derivative; the name of a derivative has no letters here.
  struct symbol_unit {
    const base::name* called = nullptr;
    int letters = 0;
    unit_product unit{};
    const units::unit* stated = nullptr; ///< null if the model does not state it
  };
  /// A symbol as phrases contain it, and its place among the units of symbols.
  struct recorded_symbol {
    const symbol_record* record = nullptr;
    int place = 0;
  };
  /// The unit of a user function, taken as the same for all arguments.
  struct function_unit {
    const describe::external_record* record = nullptr;
    unit_product unit{};
  };

  constexpr void require(const unit_product& found, const units::unit& u) {
    if (!found.fits_all) equate(found, known_unit(u));
  }
  constexpr unit_product times(const unit_product& a, const unit_product& b) {
    return a.fits_all && b.fits_all ? a : relations_.product(a, b);
  }
  constexpr unit_product over(const unit_product& a, const unit_product& b) {
    return a.fits_all && b.fits_all ? a : relations_.quotient(a, b);
  }
  static constexpr bool is_plain_number(const unit_product& u) {
    return u.is_known() && units::fits(u.known, units::dimensionless);
  }

  /// The place of a symbol, by the first letters of a name; `stated` is null if the model does not state its
  /// unit here.
  constexpr int place_of(const base::name& called, int letters, const units::unit* stated = nullptr) {
    symbol_unit* const all = symbols_.begin();
    for (int i = 0, end = symbols_.size(); i < end; ++i) {
      if (all[i].letters != letters || !are_equal(*all[i].called, called, letters)) continue;
      if (stated != nullptr && stated != all[i].stated) state(all[i], *stated);
      return i;
    }
    fits_ = fits_ && (stated == nullptr || stated->is_in_range());
    return symbols_.push(
        {&called, letters, stated != nullptr ? known_unit(*stated) : relations_.add_unknown(), stated});
  }
  static constexpr bool are_equal(const base::name& a, const base::name& b, int letters) {
    for (int i = letters - 1; i >= 0; --i) // names often differ only at the end
      if (a.letters[i] != b.letters[i]) return false;
    return true;
  }
  constexpr void state(symbol_unit& symbol, const units::unit& stated) {
    fits_ = fits_ && stated.is_in_range();
    if (symbol.stated != nullptr)
      fits_ = fits_ && *symbol.stated == stated;
    else
      require(symbol.unit, stated);
    symbol.stated = &stated;
  }

  constexpr unit_product of_symbol(const symbol_record& r) {
    const recorded_symbol* const all = records_.begin(); // compilers interpret every call to operator[]
    for (int i = records_.size() - 1; i >= 0; --i)
      if (all[i].record == &r) return unit_at(all[i].place);
    const int place = find(r);
    records_.push({&r, place});
    return unit_at(place);
  }
  constexpr unit_product unit_at(int place) {
    unit_product& unit = symbols_[place].unit;
    if (!unit.is_known()) unit = relations_.resolved(unit);
    return unit;
  }
  /// The place of a symbol that no phrase has contained before.
  constexpr int find(const symbol_record& r) {
    using symbolic::symbol_kind;
    if (r.kind == symbol_kind::time) return symbols_.push({&r.called, 0, known_unit(second), nullptr});
    int order = r.order > 0 ? r.order : 0; // that of the derivative, for each of which the name has a prime
    const int letters = r.called.length - order;
    if (r.kind == symbol_kind::speed_rate || r.kind == symbol_kind::coordinate_rate) ++order;
    if (order == 0) return place_of(r.called, letters, r.unit);
    unit_product found = unit_at(place_of(r.called, letters));
    for (int i = 0; i < order; ++i) found = relations_.quotient(found, known_unit(second));
    if (r.unit != nullptr) require(found, *r.unit);
    return symbols_.push({&r.called, 0, found, r.unit});
  }

  constexpr void push(const unit_product& u, int rank = 0) { stack_.push({u, rank}); }
  constexpr operand pop() {
    const operand top = stack_.back();
    stack_.pop();
    return top;
  }

  constexpr void step(const phrase& p, int at) {
    const describe::token& t = p.tokens[at];
    switch (t.what) {
    case token_kind::number:
      return push(t.index == describe::whole_quantity ? relations_.add_unknown() : unit_of_number);
    case token_kind::misused: return push(unit_of_number);
    case token_kind::of_load: return quantity_of_load(t);
    case token_kind::symbol: return push(of_symbol(*t.symbol));
    case token_kind::basis: return push(unit_of_number, 1);
    case token_kind::position: return push(known_unit(meter), 1);
    case token_kind::velocity: return push(known_unit(meter / second), 1);
    case token_kind::acceleration: return push(known_unit(meter / second / second), 1);
    case token_kind::angular_velocity: return push(known_unit(units::si::radian / second), 1);
    case token_kind::angular_acceleration: return push(known_unit(units::si::radian / second / second), 1);
    case token_kind::add:
    case token_kind::subtract: return add();
    case token_kind::multiply:
    case token_kind::divide:
    case token_kind::dot:
    case token_kind::cross:
    case token_kind::outer: return multiply(t.what);
    case token_kind::negate:
    case token_kind::length:
    case token_kind::wheel_axis: return;
    case token_kind::in_axes:
    case token_kind::magnitude:
    case token_kind::normalized: return transform(t.what);
    case token_kind::derivative: return divide_by(known_unit(second));
    case token_kind::partial: return divide_by(of_symbol(*t.symbol));
    case token_kind::scalar_function: return apply(p, at);
    case token_kind::composed: return compose(p, at);
    case token_kind::external: return call(t);
    }
  }

  constexpr void quantity_of_load(const describe::token& t) {
    const auto what = static_cast<describe::load_quantity>(t.index);
    const describe::path_record* const path = t.load->path;
    const bool is_given = path != nullptr && !path->ends_at_points(),
               is_length = what == describe::load_quantity::length;
    if (!is_given) return push(known_unit(describe::unit_of(what)), is_vector(what));
    if (!is_length) return push(relations_.add_unknown());
    for (int i = 0; i < path->length.size; ++i) step(path->length, i);
  }

  constexpr void divide_by(const unit_product& u) {
    operand& top = stack_.back();
    if (top.is_mixed) return fail();
    top.unit = relations_.quotient(top.unit, u);
  }

  constexpr void add() {
    const operand right = pop();
    operand& left = stack_.back();
    equate(left.unit, right.unit);
    const bool is_one_number = left.unit.fits_all != right.unit.fits_all;
    if (left.unit.fits_all) left.unit = right.unit;
    left.is_mixed =
        left.is_mixed || right.is_mixed || (is_one_number && left.rank > 0 && !is_plain_number(left.unit));
  }

  constexpr void multiply(token_kind what) {
    const operand right = pop();
    operand& left = stack_.back();
    const bool is_rotated = what == token_kind::dot || what == token_kind::cross;
    if ((left.is_mixed && !right.unit.fits_all) || (right.is_mixed && !left.unit.fits_all) ||
        (is_rotated && (left.is_mixed || right.is_mixed)))
      return fail();
    left.is_mixed = left.is_mixed || right.is_mixed;
    if (is_rotated && left.unit.fits_all && right.unit.fits_all)
      left.unit = known_unit({}); // a number that depends on angles
    else
      left.unit = what == token_kind::divide ? over(left.unit, right.unit) : times(left.unit, right.unit);
    if (what == token_kind::dot)
      left.rank += right.rank - 2;
    else if (what == token_kind::cross)
      left.rank = 1;
    else if (what != token_kind::divide)
      left.rank += right.rank;
  }

  constexpr void transform(token_kind what) {
    operand& top = stack_.back();
    if (top.is_mixed) return fail();
    if (top.unit.fits_all || what == token_kind::normalized) top.unit = known_unit({});
    if (what == token_kind::magnitude) top.rank = 0;
  }

  constexpr void apply(const phrase& p, int at) {
    const symbolic::operation op = p.tokens[at].operation;
    if (symbolic::is_binary(op)) return op == symbolic::operation::power ? raise(p, at) : apply_binary(op);
    unit_product& u = stack_.back().unit;
    using symbolic::unit_rule;
    switch (symbolic::properties_of(op).unit) {
    case unit_rule::kept: return;
    case unit_rule::root: u = root_of(u, 2); return;
    case unit_rule::cube_root: u = root_of(u, 3); return;
    case unit_rule::numbers: require(u, {}); break;
    case unit_rule::dropped: break;
    }
    u = known_unit({});
  }
  constexpr unit_product root_of(const unit_product& u, int order) {
    if (u.fits_all) return u;
    if (relations_.has_power(u, 1, order)) return relations_.power(u, 1, order);
    fail();
    return u;
  }

  constexpr void apply_binary(symbolic::operation op) {
    const unit_product b = pop().unit;
    unit_product& a = stack_.back().unit;
    using symbolic::binary_unit_rule;
    switch (symbolic::binary_properties_of(op).unit) {
    case binary_unit_rule::numbers: require(a, {}), require(b, {}); break;
    case binary_unit_rule::ratio: equate(a, b); break;
    case binary_unit_rule::kept:
      equate(a, b);
      if (a.fits_all) a = b;
      return;
    }
    a = known_unit({});
  }

  /// The power of a quantity, which is decided if its unit is 1 or if the exponent is written as a number.
  constexpr void raise(const phrase& p, int at) {
    const unit_product exponent = pop().unit;
    unit_product& u = stack_.back().unit;
    if (u.fits_all || !exponent.fits_all) {
      require(u, {}), require(exponent, {});
      u = known_unit({});
      return;
    }
    if (is_plain_number(u)) return;
    const bool is_negative = p.tokens[at - 1].what == token_kind::negate;
    const describe::token& t = p.tokens[is_negative ? at - 2 : at - 1];
    const double parts = t.number.value() * (is_negative ? -units::unit::parts : units::unit::parts);
    const auto whole = parts < 30'000 && parts > -30'000 ? static_cast<std::int64_t>(parts) : 0;
    if (t.what != token_kind::number || !base::equal(static_cast<double>(whole), parts) ||
        !relations_.has_power(u, whole, units::unit::parts))
      return fail();
    u = relations_.power(u, whole, units::unit::parts);
  }

  constexpr void compose(const phrase& p, int at) {
    using symbolic::composition;
    const describe::token& t = p.tokens[at];
    const composition f = static_cast<composition>(t.index);
    const int operands = static_cast<int>(t.number.numerator), first = stack_.size() - operands;
    if (symbolic::signature_of(f).operands == symbolic::variadic) return look_up(p, at);
    unit_product common = unit_of_number;
    for (int i = f == composition::if_positive ? 1 : 0; i < operands; ++i) {
      equate(common, stack_[first + i].unit);
      if (common.fits_all) common = stack_[first + i].unit;
    }
    for (int i = 0; i < operands; ++i) stack_.pop();
    push(f == composition::smooth_step ? known_unit({}) : common);
  }
  /// The value of a table has the unit of its values; that of numbers is unknown. Numbers must be tokens,
  /// not values of functions.
  constexpr void look_up(const phrase& p, int at) {
    const int operands = static_cast<int>(p.tokens[at].number.numerator), first = stack_.size() - operands;
    unit_product value = unit_of_number;
    bool has_numbers = false;
    for (int i = 2; i < operands; i += 2) {
      const unit_product& each = stack_[first + i].unit;
      equate(value, each);
      if (value.fits_all) value = each;
      has_numbers = has_numbers || each.fits_all;
    }
    for (int i = 1; i < operands && has_numbers; ++i)
      if (const token_kind what = p.tokens[at - i].what;
          what != token_kind::number && what != token_kind::symbol)
        fail();
    for (int i = 0; i < operands; ++i) stack_.pop();
    push(value.fits_all ? relations_.add_unknown() : value);
  }
  constexpr void call(const describe::token& t) {
    for (int i = static_cast<int>(t.number.numerator); i > 0; --i) stack_.pop();
    for (const function_unit& known : functions_)
      if (known.record == t.external) return push(known.unit);
    functions_.push({t.external, relations_.add_unknown()});
    push(functions_.back().unit);
  }

  mechanics::unit_relations relations_{};
  sequence<operand> stack_{};
  sequence<symbol_unit> symbols_{};
  sequence<recorded_symbol> records_{};
  sequence<function_unit> functions_{};
  bool fits_ = true;
};

} // namespace kanexpr::derivation
