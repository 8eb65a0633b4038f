#pragma once

#include <kanexpr/base/equal.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/numeric/elementary.hpp>
#include <kanexpr/symbolic/graph/function_table.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/live_nodes.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

namespace kanexpr::symbolic {

/// Infers units from sums: all terms of a sum have the same unit, and the argument of a sine is
/// dimensionless. Numbers and symbols may have any unit.
class equal_units {
public:
  constexpr equal_units(const graph& g, const sequence<int>& sums) : g_(g) {
    for (int id : live_values(g, sums)) live_.push(id), unit_.push(unit_of(id));
  }

  /// Whether two symbols must have the same unit.
  constexpr bool have_same_unit(int a, int b) const {
    return reduced(product({{a, 1}}, {{b, 1}}, -1)).empty();
  }

private:
  struct factor {
    int base = 0; ///< a symbol, or another node of unknown unit
    double power = 0;
  };
  using unit = sequence<factor>; ///< sorted by base

  static constexpr int time = -1; ///< a base that is not a node

  constexpr bool is_symbol(int id, symbol_kind kind) const {
    return g_[id].op == operation::symbol && g_.symbol_at(id).kind == kind;
  }

  /// A rate has the unit of its coordinate divided by that of time.
  constexpr unit unit_of_base(int id) const {
    if (is_symbol(id, symbol_kind::coordinate_rate))
      for (int of : live_)
        if (is_symbol(of, symbol_kind::coordinate) && g_.symbol_at(of).position == g_.symbol_at(id).position)
          return {{time, -1}, {of, 1}};
    return {{id, 1}};
  }

  static constexpr unit product(const unit& a, const unit& b, double power) {
    unit both;
    int i = 0, j = 0;
    while (i < a.size() || j < b.size())
      if (j == b.size() || (i < a.size() && a[i].base < b[j].base)) {
        both.push(a[i++]);
      } else if (i == a.size() || b[j].base < a[i].base) {
        both.push({b[j].base, power * b[j].power}), ++j;
      } else {
        const double sum = a[i].power + power * b[j].power;
        if (numeric::elementary::abs(sum) > 1e-9) both.push({a[i].base, sum});
        ++i, ++j;
      }
    return both;
  }

  constexpr unit reduced(unit u) const {
    for (const unit& none : dimensionless_)
      for (const factor& f : u)
        if (f.base == none.back().base) {
          u = product(u, none, -f.power / none.back().power);
          break;
        }
    return u;
  }

  constexpr void equate(const unit& a, const unit& b) {
    const unit none = reduced(product(a, b, -1));
    if (!none.empty()) dimensionless_.push(none);
  }

  constexpr const unit& of(int id) const {
    int first = 0, last = live_.size() - 1;
    while (live_[first] != id) {
      const int middle = (first + last + 1) / 2;
      live_[middle] <= id ? first = middle : last = middle - 1;
    }
    return unit_[first];
  }

  constexpr unit unit_of(int id) {
    const node& n = g_[id];
    switch (form_of(n.op)) {
    case form::negate: return of(n.a);
    case form::add:
    case form::subtract: return equate(of(n.a), of(n.b)), of(n.a);
    case form::multiply: return product(of(n.a), of(n.b), 1);
    case form::divide: return product(of(n.a), of(n.b), -1);
    case form::function: return unit_of_function(n);
    case form::binary_function: return unit_of_binary_function(n);
    case form::selection: return of(n.b);
    case form::leaf:
    case form::power:
    case form::list_operation: break; // unknown
    }
    return unit_of_base(id);
  }

  constexpr unit unit_of_function(const node& n) {
    switch (properties_of(n.op).unit) {
    case unit_rule::numbers: return equate(of(n.a), {}), unit();
    case unit_rule::kept: return of(n.a);
    case unit_rule::root: return product({}, of(n.a), 0.5);
    case unit_rule::cube_root: return product({}, of(n.a), 1.0 / 3);
    case unit_rule::dropped: break;
    }
    return {};
  }

  constexpr unit unit_of_binary_function(const node& n) {
    switch (binary_properties_of(n.op).unit) {
    case binary_unit_rule::numbers: return equate(of(n.a), {}), equate(of(n.b), {}), unit();
    case binary_unit_rule::ratio: return equate(of(n.a), of(n.b)), unit();
    case binary_unit_rule::kept: return equate(of(n.a), of(n.b)), of(n.a);
    }
    return {};
  }

  const graph& g_;
  sequence<int> live_{};           ///< in ascending order
  sequence<unit> unit_{};          ///< by index in `live_`
  sequence<unit> dimensionless_{}; ///< dimensionless products; each ends in a base that no later one contains
};

} // namespace kanexpr::symbolic
