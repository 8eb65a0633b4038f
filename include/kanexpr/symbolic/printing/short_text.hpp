#pragma once

#include <kanexpr/base/name.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/symbolic/graph/function_table.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/list.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>
#include <kanexpr/symbolic/numbers/number.hpp>

#include <cstdint>
#include <string_view>

namespace kanexpr::symbolic {

/// Writes an expression for a message, in constant expressions, too: as `print`, but in the order of the
/// graph, and shortened in the middle.
class short_text {
public:
  constexpr short_text(const graph& g, int id) : g_(g) { write(id, sum); }

  constexpr std::string_view view() const { return text_.view(); }

private:
  /// How tightly the surrounding expression binds.
  enum strength { sum, product, operand };

  constexpr void put(std::string_view text) { text_.append(text); }

  constexpr void write(int id, strength around) {
    const node& n = g_[id];
    const strength own = strength_of(id);
    if (own < around) put("(");
    write_bare(id, n);
    if (own < around) put(")");
  }

  constexpr strength strength_of(int id) const {
    switch (form_of(g_[id].op)) {
    case form::add:
    case form::subtract:
    case form::negate: return sum;
    case form::multiply: return is_square(g_[id]) ? operand : product;
    case form::divide: return product;
    case form::leaf: return g_.is_constant(id) && g_.number_at(id).negative() ? sum : operand;
    case form::power:
    case form::function:
    case form::binary_function:
    case form::selection:
    case form::list_operation: break;
    }
    return operand;
  }
  static constexpr bool is_square(const node& n) { return n.op == operation::multiply && n.a == n.b; }

  constexpr void pair(int a, strength left, std::string_view sign, int b, strength right) {
    write(a, left), put(sign), write(b, right);
  }

  constexpr void write_bare(int id, const node& n) {
    switch (form_of(n.op)) {
    case form::leaf: return g_.is_constant(id) ? write_number(g_.number_at(id)) : write_symbol(id);
    case form::negate: return put("-"), write(n.a, product);
    case form::add: return pair(n.a, sum, " + ", n.b, sum);
    case form::subtract: return pair(n.a, sum, " - ", n.b, product);
    case form::multiply:
      if (is_square(n)) return write(n.a, operand), put("^2");
      return pair(n.a, product, "*", n.b, product);
    case form::divide: return pair(n.a, product, "/", n.b, operand);
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

  constexpr void write_number(const number& n) {
    if (n.negative()) put("-");
    const number size = n.negative() ? -n : n;
    if (size.exact() && size.numerator < 1'000'000 && size.denominator < 1'000'000) {
      text_.append(static_cast<int>(size.numerator));
      if (!size.integer()) put("/"), text_.append(static_cast<int>(size.denominator));
      return;
    }
    write_decimal(size.value());
  }

  /// Six digits after the point at most.
  constexpr void write_decimal(double size) {
    if (!(size < 1e9)) return put("...");
    auto millionths = static_cast<std::int64_t>(size * 1e6 + 0.5);
    text_.append(static_cast<int>(millionths / 1'000'000));
    millionths %= 1'000'000;
    if (millionths == 0) return;
    put(".");
    for (int unit = 100'000; millionths > 0; unit /= 10) {
      text_.append(static_cast<int>(millionths / unit));
      millionths %= unit;
    }
  }

  const graph& g_;
  base::name text_{};
};

} // namespace kanexpr::symbolic
