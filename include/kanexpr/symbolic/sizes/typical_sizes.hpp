#pragma once

#include <kanexpr/base/equal.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/symbolic/graph/evaluate.hpp>
#include <kanexpr/symbolic/graph/function_table.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

namespace kanexpr::symbolic {

/// Typical sizes of symbols when none are given: the size of the terms to which they are added, or 1 for an
/// angle. A coordinate that is a length thus gets the size of the lengths that appear as numbers in the
/// model, in any units.
class typical_sizes {
public:
  constexpr explicit typical_sizes(const graph& g) : g_(g) {
    if (!holds_unusual_number()) return;
    known_.resize(g.size());
    for (int passes = 0; passes < most_passes; ++passes) {
      found_ = false;
      for (int id = 0; id < g.size(); ++id) known_[id] = estimate(g[id], id);
      sequence<double> required_size(g.size(), 0.0); // size required by the users of a node; 0: any
      for (int id = g.size() - 1; id >= 0; --id)
        if (g[id].op < operation::pair) propagate_sizes(id, required_size, passes > 0);
      if (!found_ && passes > 0) break;
    }
  }

  /// The size of a symbol, rounded to 1 unless it differs greatly from 1.
  constexpr double operator[](int symbol) const {
    for (int i = 0; i < symbols_.size(); ++i)
      if (symbols_[i] == symbol) return is_usual(sizes_[i]) ? 1 : sizes_[i];
    return 1;
  }

private:
  static constexpr int none = -1, mixed = -2;
  static constexpr int most_passes = 4;

  /// Whether a number is typical of machines described in meters and kilograms, so that no estimate is
  /// needed.
  static constexpr bool is_usual(double size) { return size > 1e-4 && size < 1e4; }
  constexpr bool holds_unusual_number() const {
    for (const number& n : g_.numbers()) {
      const double size = numeric::elementary::abs(n.value());
      if (!base::equal(size, 0.0) && !is_usual(size)) return true;
    }
    return false;
  }

  /// A factor times a power of a symbol of unknown size.
  struct estimate_of {
    double factor = 1;
    int unknown = mixed;
    double power = 0;

    constexpr bool is_known() const { return unknown == none; }
    constexpr bool is_determinable() const { return unknown >= 0 && !base::equal(power, 0.0); }
  };
  static constexpr estimate_of of_size(double size) { return {size, none, 0}; }

  constexpr estimate_of estimate(const node& n, int id) const {
    if (n.op == operation::symbol) {
      const int at = symbols_.find(id);
      return at >= 0 ? of_size(sizes_[at]) : estimate_of{1, id, 1};
    }
    if (n.op == operation::constant) return of_size(numeric::elementary::abs(g_.number_at(id).value()));
    if (n.op >= operation::pair) return {};
    const estimate_of& a = known_[n.a];
    switch (form_of(n.op)) {
    case form::negate: return a;
    case form::add:
    case form::subtract: return sum(a, known_[n.b]);
    case form::multiply: return product(a, known_[n.b], 1);
    case form::divide: return product(a, known_[n.b], -1);
    case form::binary_function:
      return binary_properties_of(n.op).unit == binary_unit_rule::kept ? sum(a, known_[n.b]) : of_size(1);
    case form::selection: return known_[n.b];
    case form::function:
      switch (properties_of(n.op).unit) {
      case unit_rule::kept: return a;
      case unit_rule::root: return {numeric::elementary::sqrt(a.factor), a.unknown, a.power / 2};
      case unit_rule::cube_root: return {numeric::elementary::cbrt(a.factor), a.unknown, a.power / 3};
      case unit_rule::numbers:
      case unit_rule::dropped: return of_size(1);
      }
      break;
    case form::leaf:
    case form::power:
    case form::list_operation: break; // unknown
    }
    return {};
  }

  constexpr estimate_of product(const estimate_of& a, const estimate_of& b, double sign) const {
    if (a.unknown == mixed || b.unknown == mixed || base::equal(b.factor, 0.0)) return {};
    if (a.is_determinable() && b.is_determinable() && a.unknown != b.unknown) return {};
    const double factor = sign > 0 ? a.factor * b.factor : a.factor / b.factor,
                 power = a.power + sign * b.power;
    return {factor, base::equal(power, 0.0) ? none : a.is_determinable() ? a.unknown : b.unknown, power};
  }

  static constexpr estimate_of sum(const estimate_of& a, const estimate_of& b) {
    if (a.is_known() && b.is_known()) return of_size(a.factor > b.factor ? a.factor : b.factor);
    if (a.is_known() && !base::equal(a.factor, 0.0)) return a;
    if (b.is_known() && !base::equal(b.factor, 0.0)) return b;
    return a.is_determinable() && b.is_determinable() && a.unknown == b.unknown &&
                   base::equal(a.power, b.power)
               ? a
               : estimate_of{};
  }

  /// Propagates the expected size to the operands of a node: first from arguments of functions, which are
  /// dimensionless, then from the other terms of sums.
  constexpr void propagate_sizes(int id, sequence<double>& required_size, bool by_terms) {
    const node& n = g_[id];
    const estimate_of& own = known_[id];
    if (is_leaf(n.op)) return assign_size(own, required_size[id]);
    if (own.is_determinable()) assign_size(own, required_size[id]);
    const double size = by_terms && own.is_known() ? own.factor : required_size[id];
    const auto want = [&](int operand, double as_large) {
      if (!known_[operand].is_known() && base::equal(required_size[operand], 0.0))
        required_size[operand] = as_large;
    };
    switch (form_of(n.op)) {
    case form::negate: return want(n.a, size);
    case form::add:
    case form::subtract: return want(n.a, size), want(n.b, size);
    case form::multiply:
      if (known_[n.a].is_known() && !base::equal(known_[n.a].factor, 0.0))
        want(n.b, size / known_[n.a].factor);
      if (known_[n.b].is_known() && !base::equal(known_[n.b].factor, 0.0))
        want(n.a, size / known_[n.b].factor);
      return;
    case form::divide:
      if (known_[n.b].is_known()) want(n.a, size * known_[n.b].factor);
      return;
    case form::function: return want(n.a, size_of_argument(properties_of(n.op).unit, size));
    case form::binary_function:
      switch (binary_properties_of(n.op).unit) {
      case binary_unit_rule::kept: return want(n.a, size), want(n.b, size);
      case binary_unit_rule::numbers: return want(n.a, 1), want(n.b, 1);
      case binary_unit_rule::ratio: return;
      }
      return;
    case form::selection: return want(n.b, size);
    case form::leaf:
    case form::power:
    case form::list_operation: return;
    }
  }
  static constexpr double size_of_argument(unit_rule rule, double size) {
    switch (rule) {
    case unit_rule::kept: return size;
    case unit_rule::root: return size * size;
    case unit_rule::cube_root: return size * size * size;
    case unit_rule::numbers:
    case unit_rule::dropped: break;
    }
    return 1;
  }
  constexpr void assign_size(const estimate_of& open, double size) {
    if (!open.is_determinable() || base::equal(open.factor, 0.0) || base::equal(size, 0.0) ||
        symbols_.contains(open.unknown))
      return;
    const double ratio = size / open.factor;
    symbols_.push(open.unknown);
    sizes_.push(base::equal(open.power, 1.0) ? ratio : numeric::elementary::pow(ratio, 1 / open.power));
    found_ = true;
  }

  const graph& g_;
  sequence<estimate_of> known_{};
  sequence<int> symbols_{};
  sequence<double> sizes_{};
  bool found_ = false;
};

} // namespace kanexpr::symbolic
