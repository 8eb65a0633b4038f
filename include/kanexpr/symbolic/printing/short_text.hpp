#pragma once

#include <kanexpr/base/name.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/symbolic/graph/function_table.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/list.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>
#include <kanexpr/symbolic/numbers/decimal_text.hpp>
#include <kanexpr/symbolic/numbers/number.hpp>

#include <string_view>

namespace kanexpr::symbolic {

/// Writes an expression for a message, in constant expressions, too: as `print`, but in the order of the
/// graph, and shortened in the middle. Only the first `most_nodes` nodes are written.
class short_text {
public:
  constexpr short_text(const graph& g, int id) : g_(g) { write(id, sum); }

  constexpr std::string_view view() const { return text_.view(); }

private:
  static constexpr int most_nodes = 2000;

  /// How tightly the surrounding expression binds.
  enum strength { sum, product, operand };

  constexpr void put(std::string_view text) {
    if (left_ > 0) text_.append(text);
  }

  constexpr void write(int id, strength around) {
    if (left_ == 1) put("...");
    if (left_ > 0) --left_;
    if (left_ == 0) return;
    const node& n = g_[id];
    const strength own = strength_of(id);
    if (own < around) put("(");
    write_bare(id, n);
    if (own < around) put(")");
  }

  constexpr strength strength_of(int id) {
    switch (form_of(g_[id].op)) {
    case form::add:
    case form::subtract:
    case form::negate: return sum;
    case form::multiply:
    case form::divide: return product_of(id).binds();
    case form::leaf: return g_.is_constant(id) && g_.number_at(id).negative() ? sum : operand;
    case form::power:
    case form::function:
    case form::binary_function:
    case form::selection:
    case form::list_operation: break;
    }
    return operand;
  }
  /// A power of a factor of a product.
  struct factor {
    int id = 0;
    int exponent = 0;
  };
  /// A product of a number and powers of other nodes.
  struct flat_product {
    number coefficient = exactly(1);
    sequence<factor> factors{};

    constexpr strength binds() const {
      return coefficient == exactly(1) && factors.size() == 1 && factors[0].exponent > 0 ? operand : product;
    }
    constexpr void add(int id, int exponent) {
      for (factor& f : factors)
        if (f.id == id) {
          f.exponent += exponent;
          return;
        }
      factors.push({id, exponent});
    }
  };

  constexpr flat_product product_of(int id) {
    flat_product all;
    gather(all, id, 1);
    for (int i = 1; i < all.factors.size(); ++i) // sorts by insertion
      for (int j = i; j > 0 && precedes(all.factors[j].id, all.factors[j - 1].id); --j) {
        const factor moved = all.factors[j];
        all.factors[j] = all.factors[j - 1];
        all.factors[j - 1] = moved;
      }
    return all;
  }
  constexpr void gather(flat_product& all, int id, int exponent) {
    const node& n = g_[id];
    if (left_ > 1 && (n.op == operation::multiply || n.op == operation::divide)) {
      --left_;
      gather(all, n.a, exponent);
      gather(all, n.b, n.op == operation::multiply ? exponent : -exponent);
    } else if (n.op == operation::constant && id != graph::zero) {
      const number& value = g_.number_at(id);
      all.coefficient = exponent > 0 ? all.coefficient * value : all.coefficient / value;
    } else
      all.add(id, exponent);
  }

  /// Parameters precede other symbols, and symbols everything else; symbols are sorted by name.
  constexpr bool precedes(int a, int b) const {
    if (rank(a) != rank(b)) return rank(a) < rank(b);
    return rank(a) < 2 && g_.symbol_at(a).called.view() < g_.symbol_at(b).called.view();
  }
  constexpr int rank(int id) const {
    if (g_[id].op != operation::symbol) return 2;
    return g_.symbol_at(id).kind == symbol_kind::parameter ? 0 : 1;
  }

  constexpr void write_product(int id) {
    const flat_product all = product_of(id);
    const number size = all.coefficient.negative() ? -all.coefficient : all.coefficient;
    if (all.coefficient.negative()) put("-");
    write_side(all, size.exact() ? exactly(size.numerator) : size, 1);
    const number divisor = exactly(size.exact() ? size.denominator : 1);
    int below = divisor == exactly(1) ? 0 : 1;
    for (const factor& f : all.factors) below += f.exponent < 0 ? 1 : 0;
    if (below == 0) return;
    put(below > 1 ? "/(" : "/");
    write_side(all, divisor, -1);
    if (below > 1) put(")");
  }
  /// Writes the factors above (1) or below (−1) the line.
  constexpr void write_side(const flat_product& all, const number& coefficient, int sign) {
    bool is_first = true;
    for (const factor& f : all.factors) is_first = is_first && f.exponent * sign <= 0;
    const bool shows_number = is_first || !(coefficient == exactly(1));
    if (shows_number) put(decimal_text(coefficient).view());
    is_first = !shows_number;
    for (const factor& f : all.factors) {
      if (f.exponent * sign <= 0) continue;
      if (!is_first) put("*");
      is_first = false;
      write(f.id, operand);
      if (f.exponent * sign == 1) continue;
      base::name exponent;
      exponent.append(f.exponent * sign);
      put("^"), put(exponent.view());
    }
  }

  constexpr void pair(int a, strength left, std::string_view sign, int b, strength right) {
    write(a, left), put(sign), write(b, right);
  }

  constexpr void write_bare(int id, const node& n) {
    switch (form_of(n.op)) {
    case form::leaf:
      return g_.is_constant(id) ? put(decimal_text(g_.number_at(id)).view()) : write_symbol(id);
    case form::negate: return put("-"), write(n.a, product);
    case form::add: return pair(n.a, sum, " + ", n.b, sum);
    case form::subtract: return pair(n.a, sum, " - ", n.b, product);
    case form::multiply:
    case form::divide: return write_product(id);
    case form::power: return pair(n.a, operand, "^", n.b, operand);
    case form::function:
    case form::binary_function:
    case form::selection: break;
    case form::list_operation: return n.op == operation::call ? write_call(id) : put("...");
    }
    put(function_name(n.op)), put("("), write(n.a, sum);
    if (is_binary(n.op)) put(", "), write(n.b, sum);
    put(is_selection(n.op) ? ", 0)" : ")");
  }

  constexpr void write_call(int id) {
    put(g_.external_at(id).called.view()), put("(");
    const sequence<int> operands = elements_of(g_, g_[id].a);
    for (int i = 0; i < operands.size(); ++i) {
      if (i > 0) put(", ");
      write(operands[i], sum);
    }
    put(")");
  }

  constexpr void write_symbol(int id) {
    const symbol& s = g_.symbol_at(id);
    put(s.called.view());
    if (s.kind == symbol_kind::coordinate_rate || s.kind == symbol_kind::speed_rate) put("'");
  }

  const graph& g_;
  int left_ = most_nodes;
  base::name text_{};
};

} // namespace kanexpr::symbolic
