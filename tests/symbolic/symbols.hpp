#pragma once

#include <kanexpr/symbolic/graph/functions.hpp>

/// The symbols of formulas in tests of the expression graph.
struct symbols {
  using expression = kanexpr::symbolic::expression;
  using kind = kanexpr::symbolic::symbol_kind;

  kanexpr::symbolic::graph g;
  expression a = of(kind::parameter, "a"), b = of(kind::parameter, "b"), c = of(kind::parameter, "c"),
             m = of(kind::parameter, "m"), r = of(kind::parameter, "r"), x = of(kind::input, "x"),
             y = of(kind::input, "y"), z = of(kind::input, "z"), q1 = of(kind::coordinate, "q1"),
             q2 = of(kind::coordinate, "q2"), u1 = of(kind::speed, "u1"), u2 = of(kind::speed, "u2"),
             q1_rate = of(kind::coordinate_rate, "q1"), u1_rate = of(kind::speed_rate, "u1");

  expression of(kind k, const char* name) {
    return kanexpr::symbolic::variable(g, {k, kanexpr::base::name(name), 0});
  }
  expression number(double value) { return constant(g, kanexpr::symbolic::real(value)); }
  expression fraction(int numerator, int denominator) {
    return constant(g, kanexpr::symbolic::exactly(numerator, denominator));
  }
};
