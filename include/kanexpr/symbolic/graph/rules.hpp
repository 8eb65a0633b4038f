#pragma once

#include <kanexpr/base/equal.hpp>
#include <kanexpr/numeric/elementary.hpp>
#include <kanexpr/symbolic/graph/function_table.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

/// Builds expressions in their simplest local form.
///
/// Each rule inspects at most two levels and never makes an expression larger. Signs move outward, where the
/// next sum absorbs them; constants move to the front; commutative operands are sorted by node number, so
/// that equal expressions become one node. Compilers interpret each call, so the most frequent functions
/// access the nodes directly and contain the most frequent tests.
namespace kanexpr::symbolic {

constexpr int negate(graph& g, int a);
constexpr int add(graph& g, int a, int b);
constexpr int subtract(graph& g, int a, int b);
constexpr int multiply(graph& g, int a, int b);
constexpr int divide(graph& g, int a, int b);

namespace detail {

/// The coefficient c of a node c*x with given x; 1 if there is none.
constexpr number coefficient_of(const graph& g, int a, int x) {
  return a == x ? exactly(1) : g.number_at(g[a].a);
}

/// x for sin(x)*sin(x) or cos(x)*cos(x), else -1.
constexpr int squared_angle(const graph& g, int a, operation function) {
  const node& n = g[a];
  return n.op == operation::multiply && n.a == n.b && g[n.a].op == function ? g[n.a].a : -1;
}

/// Whether two products are sin² and cos² of the same angle.
constexpr bool is_pythagorean(const graph& g, int a, int b) {
  const int s = squared_angle(g, a, operation::sin);
  return s >= 0 && s == squared_angle(g, b, operation::cos);
}

/// The factors of nested products, sorted by node number; none if there are too many.
struct product_factors {
  static constexpr int most = 8;
  int factor[most]{};
  int count = 0;

  constexpr product_factors(const graph& g, int product) {
    take(g, product);
    if (count > most) count = 0;
  }
  constexpr bool operator==(const product_factors& other) const {
    if (count != other.count || count == 0) return false;
    for (int i = 0; i < count; ++i)
      if (factor[i] != other.factor[i]) return false;
    return true;
  }

private:
  constexpr void take(const graph& g, int id) {
    const node& n = g[id];
    if (n.op == operation::multiply) {
      take(g, n.a);
      if (count <= most) take(g, n.b);
    } else if (count++ < most) {
      int place = count - 1;
      for (; place > 0 && factor[place - 1] > id; --place) factor[place] = factor[place - 1];
      factor[place] = id;
    }
  }
};

} // namespace detail

constexpr int negate(graph& g, int a) {
  const node n = g.nodes_[a];
  if (n.op == operation::constant) return g.constant(-g.number_at(a));
  if (n.op == operation::negate) return n.a;
  if (n.op == operation::subtract) {
    const int turned = g.find(operation::subtract, n.b, n.a);
    if (turned >= 0) return turned;
  }
  return g.find_or_append(operation::negate, a, 0);
}

constexpr int add(graph& g, int a, int b) {
  if (a == graph::zero) return b;
  if (b == graph::zero) return a;
  node x, y;
  if (__builtin_is_constant_evaluated()) {
    const auto& nodes = g.block_->value;
    x = nodes[a];
    y = nodes[b];
  } else {
    x = g.nodes_[a];
    y = g.nodes_[b];
  }
  if (x.op == operation::constant) {
    if (y.op == operation::constant) return g.constant(g.number_at(a) + g.number_at(b));
    if (y.op == operation::add && g.nodes_[y.a].op == operation::constant)
      return add(g, g.constant(g.number_at(a) + g.number_at(y.a)), y.b);
    return g.find_or_append(operation::add, a, b);
  }
  if (y.op == operation::constant) return add(g, b, a);
  if (x.op == operation::negate)
    return y.op == operation::negate ? negate(g, add(g, x.a, y.a)) : subtract(g, b, x.a);
  if (y.op == operation::negate) return subtract(g, a, y.a);
  if (x.op == operation::subtract && x.b == b) return x.a;
  if (y.op == operation::subtract && y.b == a) return y.a;
  if (a == b) return multiply(g, g.constant(exactly(2)), a);
  const int of_a = x.op == operation::multiply && g.nodes_[x.a].op == operation::constant ? x.b : a,
            of_b = y.op == operation::multiply && g.nodes_[y.a].op == operation::constant ? y.b : b;
  if (of_a == of_b)
    return multiply(g, g.constant(detail::coefficient_of(g, a, of_a) + detail::coefficient_of(g, b, of_b)),
                    of_a);
  if (x.op == operation::multiply && y.op == operation::multiply && x.a == x.b && y.a == y.b &&
      (detail::is_pythagorean(g, a, b) || detail::is_pythagorean(g, b, a)))
    return graph::one;
  // constants move to the front: (c + x) + y becomes c + (x + y) only if c is then combined with another
  // constant
  if (x.op == operation::add && g.nodes_[x.a].op == operation::constant && y.op == operation::add &&
      g.nodes_[y.a].op == operation::constant) {
    const int c = g.constant(g.number_at(x.a) + g.number_at(y.a));
    return add(g, c, add(g, x.b, y.b));
  }
  return a < b ? g.find_or_append(operation::add, a, b) : g.find_or_append(operation::add, b, a);
}

constexpr int subtract(graph& g, int a, int b) {
  if (a == b) return graph::zero;
  if (a == graph::zero) return negate(g, b);
  if (b == graph::zero) return a;
  node x, y;
  if (__builtin_is_constant_evaluated()) {
    const auto& nodes = g.block_->value;
    x = nodes[a];
    y = nodes[b];
  } else {
    x = g.nodes_[a];
    y = g.nodes_[b];
  }
  if (y.op == operation::constant) return add(g, g.constant(-g.number_at(b)), a);
  if (y.op == operation::negate) return add(g, a, y.a);
  if (x.op == operation::negate) return negate(g, add(g, x.a, b));
  if (x.op == operation::add) {
    if (x.a == b) return x.b;
    if (x.b == b) return x.a;
  }
  if (x.op == operation::subtract && x.a == b) return negate(g, x.b);
  if (y.op == operation::add) {
    if (y.a == a) return negate(g, y.b);
    if (y.b == a) return negate(g, y.a);
  }
  if (y.op == operation::subtract && y.a == a) return y.b;
  if (x.op == operation::constant) {
    if (y.op == operation::add && g.nodes_[y.a].op == operation::constant)
      return subtract(g, g.constant(g.number_at(a) - g.number_at(y.a)), y.b);
    // 1 - sin² is not rewritten: cos² costs a product and may need a cosine that is not needed otherwise
  } else {
    const int of_a = x.op == operation::multiply && g.nodes_[x.a].op == operation::constant ? x.b : a,
              of_b = y.op == operation::multiply && g.nodes_[y.a].op == operation::constant ? y.b : b;
    if (of_a == of_b)
      return multiply(g, g.constant(detail::coefficient_of(g, a, of_a) - detail::coefficient_of(g, b, of_b)),
                      of_a);
    if (x.op == operation::multiply && y.op == operation::multiply &&
        (g.nodes_[x.a].op == operation::multiply || g.nodes_[x.b].op == operation::multiply) &&
        (g.nodes_[y.a].op == operation::multiply || g.nodes_[y.b].op == operation::multiply) &&
        detail::product_factors(g, a) == detail::product_factors(g, b))
      return graph::zero;
  }
  const int turned = g.find(operation::subtract, b, a);
  if (turned >= 0) return negate(g, turned);
  return g.find_or_append(operation::subtract, a, b);
}

constexpr int multiply(graph& g, int a, int b) {
  if (a == graph::zero || b == graph::zero) return graph::zero;
  if (a == graph::one) return b;
  if (b == graph::one) return a;
  operation left{}, right{};
  if (__builtin_is_constant_evaluated()) {
    const auto& nodes = g.block_->value;
    left = nodes[a].op;
    right = nodes[b].op;
  } else {
    left = g.nodes_[a].op;
    right = g.nodes_[b].op;
  }
  if (left == operation::constant) {
    const number c = g.number_at(a);
    if (right == operation::constant) return g.constant(c * g.number_at(b));
    if (c.negative()) return negate(g, multiply(g, g.constant(-c), b));
    if (right == operation::negate) return negate(g, multiply(g, a, g.nodes_[b].a));
    if (right == operation::multiply) {
      const node product = g.nodes_[b];
      if (g.nodes_[product.a].op == operation::constant)
        return multiply(g, g.constant(c * g.number_at(product.a)), product.b);
    }
    return g.find_or_append(operation::multiply, a, b);
  }
  if (right == operation::constant) return multiply(g, b, a);
  if (left == operation::negate) {
    const int opposite = g.nodes_[a].a;
    return right == operation::negate ? multiply(g, opposite, g.nodes_[b].a)
                                      : negate(g, multiply(g, opposite, b));
  }
  if (right == operation::negate) return negate(g, multiply(g, a, g.nodes_[b].a));
  if (left == operation::sqrt && a == b) return g.nodes_[a].a;
  if (left == operation::divide && g.nodes_[a].b == b) return g.nodes_[a].a;
  if (right == operation::divide && g.nodes_[b].b == a) return g.nodes_[b].a;
  if (left == operation::multiply && right == operation::multiply) {
    const node x = g.nodes_[a], y = g.nodes_[b];
    if (g.nodes_[x.a].op == operation::constant && g.nodes_[y.a].op == operation::constant) {
      const int c = g.constant(g.number_at(x.a) * g.number_at(y.a));
      return multiply(g, c, multiply(g, x.b, y.b));
    }
  }
  return a < b ? g.find_or_append(operation::multiply, a, b) : g.find_or_append(operation::multiply, b, a);
}

/// A division by the constant zero is not simplified; the model reports it as a mistake.
constexpr int divide(graph& g, int a, int b) {
  if (b == graph::one) return a;
  node x, y;
  if (__builtin_is_constant_evaluated()) {
    const auto& nodes = g.block_->value;
    x = nodes[a];
    y = nodes[b];
  } else {
    x = g.nodes_[a];
    y = g.nodes_[b];
  }
  if (b != graph::zero) {
    if (a == graph::zero) return graph::zero;
    if (y.op == operation::constant) return multiply(g, g.constant(exactly(1) / g.number_at(b)), a);
    if (a == b) return graph::one;
  }
  if (x.op == operation::negate) return negate(g, divide(g, x.a, b));
  if (y.op == operation::negate) return negate(g, divide(g, a, y.a));
  if (x.op == operation::multiply) {
    if (x.a == b) return x.b;
    if (x.b == b) return x.a;
  }
  if (y.op == operation::divide && x.op == operation::constant && a == graph::one) return divide(g, y.b, y.a);
  if (y.op == operation::sqrt && y.a == a) return b;
  return g.find_or_append(operation::divide, a, b);
}

/// Rounds function values near zero: the cosine of the double nearest to π/2 is zero.
constexpr number round_near_zero(double value, double argument) {
  return real(numeric::elementary::abs(value) <= 0x1p-51 * numeric::elementary::abs(argument) &&
                      !base::equal(value, argument)
                  ? 0
                  : value);
}

/// The exact root of a fraction if it is rational, otherwise a double.
constexpr number root_of(const number& n) {
  const number folded = real(numeric::elementary::sqrt(n.value()));
  if (!n.exact() || folded.exact()) return folded;
  const number above = real(numeric::elementary::sqrt(static_cast<double>(n.numerator)));
  const number below = real(numeric::elementary::sqrt(static_cast<double>(n.denominator)));
  return above.exact() && below.exact() ? above / below : folded;
}

/// The value of a function at a constant.
constexpr number function_of(operation op, const number& n) {
  if (op == operation::sqrt) return root_of(n);
  if (op == operation::abs) return n.negative() ? -n : n;
  const double x = n.value(), f = properties_of(op).value(x);
  return op == operation::sin || op == operation::cos ? round_near_zero(f, x) : real(f);
}

/// Applies a function of one argument.
constexpr int apply(graph& g, operation op, int a) {
  const node x = g[a];
  if (x.op == operation::constant) return g.constant(function_of(op, g.number_at(a)));
  if (x.op == operation::negate) {
    switch (properties_of(op).symmetry) {
    case parity::even: return apply(g, op, x.a);
    case parity::odd: return negate(g, apply(g, op, x.a));
    case parity::none: break;
    }
  }
  if (op == operation::abs && x.op == operation::abs) return a;
  return g.find_or_append(op, a, 0);
}

/// Applies a function of two arguments.
constexpr int apply(graph& g, operation op, int a, int b) {
  if (g.is_constant(a) && g.is_constant(b))
    return g.constant(real(binary_properties_of(op).value(g.number_at(a).value(), g.number_at(b).value())));
  return g.find_or_append(op, a, b);
}

constexpr int selected(graph& g, operation op, int condition, int x) {
  if (x == graph::zero) return graph::zero;
  if (g.is_constant(condition)) {
    const number& c = g.number_at(condition);
    const bool is_positive = !c.negative() && condition != graph::zero;
    if (base::is_number(c.value())) return is_positive == (op == operation::if_positive) ? x : graph::zero;
  }
  const node n = g[x];
  if (n.op == operation::negate) return negate(g, selected(g, op, condition, n.a));
  if (n.op == op && n.a == condition) return x;
  return g.find_or_append(op, condition, x);
}

constexpr int integer_power(graph& g, int base, std::int64_t exponent) {
  if (exponent == 0) return graph::one;
  if (exponent < 0) return divide(g, graph::one, integer_power(g, base, -exponent));
  if (exponent == 1) return base;
  const int half = integer_power(g, base, exponent / 2);
  const int even = multiply(g, half, half);
  return exponent % 2 == 0 ? even : multiply(g, base, even);
}

/// Builds integer powers as products and half powers as square roots; other exponents use `pow`.
constexpr int power(graph& g, int base, int exponent) {
  if (base == graph::one) return graph::one;
  if (g.is_constant(exponent)) {
    const number n = g.number_at(exponent);
    constexpr std::int64_t largest = 64;
    if (n.exact() && n.numerator <= largest && n.numerator >= -largest) {
      if (n.denominator == 1) return integer_power(g, base, n.numerator);
      if (n.denominator == 2) return integer_power(g, apply(g, operation::sqrt, base), n.numerator);
    }
    if (n == number{0, 0, 0.5}) return apply(g, operation::sqrt, base);
    if (g.is_constant(base))
      return g.constant(real(numeric::elementary::pow(g.number_at(base).value(), n.value())));
  }
  return g.find_or_append(operation::power, base, exponent);
}

} // namespace kanexpr::symbolic
