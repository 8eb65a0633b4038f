// builds: clang++ sanitize
#include "symbolic/random_formula.hpp"

#include <kanexpr/symbolic/derivatives/differentiate.hpp>
#include <kanexpr/symbolic/limits/limit.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace kanexpr::symbolic;
using graph_evaluation::are_close;
using graph_evaluation::evaluate;
using real = long double;

class limits : public testing::Test, protected symbols {
protected:
  static constexpr double right_angle = 1.5707963267948966;

  point_values all_at(const std::vector<expression>& entries, const std::vector<replacement>& point) {
    matrix all(g, 1, static_cast<int>(entries.size()));
    for (int i = 0; i < all.columns; ++i) all(0, i) = entries[static_cast<std::size_t>(i)];
    return limits_at(g, all, point);
  }
  expression at(const std::vector<replacement>& point, expression e) {
    const point_values found = all_at({e}, point);
    for (const singularity& each : found.singular) ADD_FAILURE() << print(e) << ": " << each.condition;
    return found.values(0, 0);
  }
  expression at_zero(expression e) { return at({{q1, number(0)}, {q2, number(0)}}, e); }
  /// The conditions of the singular entries.
  std::string condition(const std::vector<replacement>& point, expression e) {
    const point_values found = all_at({e}, point);
    return found.singular.size() == 1 ? found.singular[0].condition : "";
  }
  std::string condition_at_zero(expression e) { return condition({{q1, number(0)}, {q2, number(0)}}, e); }
  std::string condition_at_right_angle(expression e) { return condition({{q1, number(right_angle)}}, e); }
};

TEST_F(limits, of_quotients_are_exact) {
  const expression q = q1, p = q2;
  EXPECT_EQ(at_zero(sin(q) / tan(q)), number(1));
  EXPECT_EQ(at_zero((1 - cos(q)) / (q * q)), fraction(1, 2));
  EXPECT_EQ(at_zero(tan(q) * sin(p) / (sin(q) * tan(2 * p))), fraction(1, 2));
  EXPECT_EQ(at_zero((q - sin(q)) / (q * q * q)), fraction(1, 6));
  EXPECT_EQ(at_zero((cos(q) - 1 + q * q / 2) / (sin(q) * sin(q) * q * tan(q))), fraction(1, 24));
  EXPECT_EQ(at_zero((exp(q) - q - 1) / (3 * q * q)), fraction(1, 6));
  EXPECT_EQ(at_zero(log(1 - q) / q), number(-1));
  EXPECT_EQ(at_zero((sqrt(q + 4) - 2) / q), fraction(1, 4));
  EXPECT_EQ(at_zero((power(q + 1, fraction(1, 3)) - 1) / q), fraction(1, 3));
  EXPECT_EQ(at_zero((asin(q) - atan(q)) / (q * q * q)), fraction(1, 2));
  EXPECT_EQ(at_zero((tan(q) - tanh(q)) / (q * q * q)), fraction(2, 3));
  EXPECT_EQ(at_zero((sinh(q) - sin(q)) / (q * q * q)), fraction(1, 3));
  EXPECT_EQ(at_zero((cosh(q) - 1) / (q * q)), fraction(1, 2));
  EXPECT_EQ(at_zero((cbrt(q - 8) + 2) / q), fraction(1, 12));
  EXPECT_EQ(at_zero(cbrt(q * q * q) / q), number(1));
  EXPECT_EQ(at_zero(wrap_to_pi(2 * q) / sin(q)), number(2));
  EXPECT_EQ(at_zero(erf(q) / q), number(2 / std::sqrt(std::acos(-1.0))));
  EXPECT_EQ(at({{x, fraction(2, 3)}}, (9 * x * x - 4) / (3 * x - 2)), number(4));
}

TEST_F(limits, let_poles_cancel) {
  const expression q = q1;
  EXPECT_EQ(at_zero(1 / q - 1 / sin(q)), number(0));
  EXPECT_EQ(at_zero((1 / q - 1 / tan(q)) / q), fraction(1, 3));
  EXPECT_EQ(at_zero(1 / (q * q) - 1 / (sin(q) * sin(q))), fraction(-1, 3));
  EXPECT_EQ(at_zero(1 / (1 / q + 1)), number(0));
  EXPECT_EQ(at_zero(sin(1 / (1 / q + 1 / (2 * q))) / q), fraction(2, 3));
}

TEST_F(limits, of_nested_quotients) {
  const expression q = q1, once = sin(q) / q - 1, twice = (cos(once) - 1) / (q * q * q * q);
  EXPECT_EQ(at_zero(once / (q * q)), fraction(-1, 6));
  EXPECT_EQ(at_zero(twice), fraction(-1, 72));
  EXPECT_EQ(at_zero(exp(twice + fraction(1, 72)) * once / (1 - cos(q))), fraction(-1, 3));
}

TEST_F(limits, keep_the_symbols_that_stay) {
  EXPECT_EQ(at_zero((a * sin(q1) + b * q1) / q1), a + b);
  EXPECT_EQ(at_zero(tan(a * q1) / q1), a);
  EXPECT_EQ(at_zero((sin(q1 + x) - sin(x)) / q1), cos(x));
  EXPECT_EQ(at_zero((tanh(q1 + x) - tanh(x)) / q1), 1 - tanh(x) * tanh(x));
  EXPECT_EQ(at_zero((cosh(q1 + x) - cosh(x)) / q1), sinh(x));
  EXPECT_EQ(print(at_zero((cbrt(q1 + a) - cbrt(a)) / q1)), "cbrt(a)/(3*a)");
  EXPECT_EQ(at_zero((power(q1 + 1, a) - 1) / q1), a);
  EXPECT_EQ(print(at_zero((b * sin(3 * q1) + c * tan(q1)) / (5 * a * q1 + q1 * q1))), "(3*b + c)/(5*a)");
  EXPECT_EQ(at({{x, a}}, (sin(x) - sin(a)) / (x - a)), cos(a));
  EXPECT_EQ(print(at({{x, a}, {y, b}}, (x * y - a * b) * (x - a) / (x - a))), "0");
}

TEST_F(limits, replace_all_at_once) {
  EXPECT_EQ(at({{x, y}, {y, x}}, x / (y * y)), y / (x * x));
  EXPECT_EQ(at({{x, y}, {y, x}, {q1, number(0)}}, x * x * sin(q1 * y) / q1), y * y * x);
}

TEST_F(limits, from_all_sides_where_these_agree) {
  const expression q = q1, p = q2;
  EXPECT_EQ(at_zero(q * q / abs(q)), number(0));
  EXPECT_EQ(at_zero(q * sign(q) / abs(q)), number(1));
  EXPECT_EQ(at_zero((q * q + p * p) / sqrt(q * q + p * p)), number(0));
  EXPECT_EQ(at_zero((q * q - p * p) / (q - p)), number(0));
  EXPECT_EQ(at_zero((sin(q) - sin(p)) / (q - p)), number(1));
  EXPECT_EQ(at_zero(atan2(2 * q * q, 2 * q * q)), number(right_angle / 2));
  EXPECT_EQ(at_zero(atan(1 / (q * q))), number(right_angle));
}

TEST_F(limits, do_not_exist_where_the_sides_disagree) {
  const expression q = q1, p = q2;
  EXPECT_EQ(condition_at_zero(q / p), "the limit of q1/q2 at q1 = 0, q2 = 0 depends on the direction");
  EXPECT_EQ(condition_at_zero(sqrt(q * q) / q),
            "the limit of sqrt(q1^2)/q1 at q1 = 0 depends on the direction");
  EXPECT_EQ(condition_at_zero(a * (abs(q) / q)),
            "the limit of abs(q1)/q1 at q1 = 0 depends on the direction");
  EXPECT_EQ(condition_at_zero(sign(q) + sin(q) / q),
            "the limit of sign(q1) at q1 = 0 depends on the direction");
  EXPECT_EQ(condition_at_zero(atan2(q, p)),
            "the limit of atan2(q1, q2) at q1 = 0, q2 = 0 depends on the direction");
  EXPECT_EQ(condition_at_zero(q * p / (q * q + p * p)),
            "the limit of q1*q2/(q1^2 + q2^2) at q1 = 0, q2 = 0 depends on the direction");
  EXPECT_EQ(condition_at_zero(wrap_to_pi(q + 3.141592653589793) * (sin(q) / q)),
            "the limit of wrap_to_pi(q1 + 3.141592653589793) at q1 = 0 depends on the direction");
  EXPECT_EQ(condition_at_zero(acos(cos(q)) / q),
            "the limit of acos(cos(q1))/q1 at q1 = 0 depends on the direction");
}

TEST_F(limits, are_looked_at_from_sides_that_part_the_signs) {
  const expression q = q1, p = q2;
  const std::vector<replacement> all{{a, number(0)}, {q, number(0)}, {p, number(0)}, {u1, number(0)}};
  const expression symbols_there[] = {a, q, p, u1};
  for (const expression e : symbols_there)
    for (const expression f : symbols_there) {
      if (e.node() >= f.node()) continue;
      EXPECT_THAT(condition(all, abs(e * f) / (e * f) + a * q * p * u1 / sin(a * q * p * u1)),
                  testing::HasSubstr("direction"));
    }
  EXPECT_THAT(condition_at_zero(sin(q) / q + sign(q * (q - p))), testing::HasSubstr("direction"));
  // the negative x axis is a branch cut
  EXPECT_THAT(condition_at_zero(atan2(q * q * q, p)), testing::HasSubstr("direction"));
  EXPECT_THAT(condition_at_zero(sin(p) / p * atan2(q, x)), testing::HasSubstr("direction"));
  EXPECT_EQ(at_zero(sin(p) / p * atan2(q, a)), number(0));
  EXPECT_THAT(condition_at_zero(sin(q) / q / (abs(x) - x + q)),
              testing::HasSubstr("signs of the remaining symbols"));
}

TEST_F(limits, do_not_exist_at_poles) {
  const expression q = q1;
  EXPECT_EQ(condition_at_zero(x / q + sin(q) / q), "q1 in a denominator vanishes at q1 = 0");
  EXPECT_EQ(condition_at_zero(cos(q) / (a * sin(q))), "a*sin(q1) in a denominator vanishes at q1 = 0");
  EXPECT_EQ(condition_at_zero(sin(q) / tan(q) + 1 / sin(q2)), "sin(q2) in a denominator vanishes at q2 = 0");
  EXPECT_EQ(condition_at_right_angle(1 / cos(q)),
            "cos(q1) in a denominator vanishes at q1 = 1.5707963267948966");
  EXPECT_EQ(condition_at_right_angle(tan(q)), "tan(q1) is not finite at q1 = 1.5707963267948966");
  EXPECT_EQ(condition({{a, b}}, x / (a - b)), "a - b in a denominator vanishes at a = b");
  expression sum = q;
  for (int i = 2; i < 9; ++i) sum = sum + sin(number(i) * q) * power(x, number(i));
  EXPECT_EQ(condition_at_zero(1 / sum), "a denominator vanishes at q1 = 0");
}

TEST_F(limits, are_not_found_without_power_series) {
  EXPECT_EQ(condition_at_zero(q1 * log(q1)), "log(q1) is not finite at q1 = 0");
  EXPECT_EQ(condition_at_zero(sin(q1) / sqrt(q1)), "sqrt(q1) has no derivative at q1 = 0");
  EXPECT_EQ(condition_at_zero(tanh(1 / q1)), "the argument of tanh(1/q1) is not finite at q1 = 0");
  EXPECT_EQ(condition_at_zero(exp(1 / q1)), "the argument of exp(1/q1) is not finite at q1 = 0");
  EXPECT_EQ(condition({{a, number(-1)}}, sqrt(a)), "sqrt(a) is not real at a = -1");
}

TEST_F(limits, count_what_vanishes_otherwise_than_by_its_form) {
  const expression one = sin(a) * sin(a) + cos(b) * cos(b) - 1 + (cos(a) * cos(a) + sin(b) * sin(b) - 1);
  EXPECT_EQ(condition_at_zero(x / one),
            "sin(a)^2 + sin(b)^2 + cos(a)^2 + cos(b)^2 - 2 in a denominator vanishes identically");
  EXPECT_EQ(condition_at_zero(q1 / (sin(2 * q1) - 2 * (sin(q1) * cos(q1)))),
            "sin(2*q1) - 2*sin(q1)*cos(q1) in a denominator vanishes identically");
  const expression turning = sin(a) * sin(a) + cos(a + q1) * cos(a + q1) - 1;
  EXPECT_EQ(at_zero(q1 / (q1 + q1 * turning)), number(1));
  EXPECT_EQ(print(at_zero(turning / q1)), "-2*sin(a)*cos(a)");
  const std::vector<replacement> decimals{{a, number(0.1)}, {b, number(0.2)}, {c, number(0.3)}};
  EXPECT_EQ(condition(decimals, x / (a + b - c)),
            "a + b - c in a denominator vanishes at a = 0.1, b = 0.2, c = 0.3");
  EXPECT_EQ(at(decimals, (a + b - c) * x / (a + b - c)), x);
  EXPECT_EQ(at({{q1, number(right_angle)}}, cos(q1) / (q1 - number(right_angle))), number(-1));
  EXPECT_EQ(at({{a, number(1e-30)}}, x * a / (a * a)), x * number(1e30));
}

TEST_F(limits, are_told_by_entry) {
  matrix all(g, 2, 2);
  all(0, 0) = sin(q1) / q1, all(0, 1) = 1 / q1, all(1, 0) = x + q1, all(1, 1) = q2 / q1;
  const point_values found = limits_at(g, all, {{q1, number(0)}});
  EXPECT_EQ(found.values(0, 0), number(1));
  EXPECT_EQ(found.values(1, 0), x);
  ASSERT_EQ(found.singular.size(), 2u);
  EXPECT_THAT((std::vector{found.singular[0].row, found.singular[0].column, found.singular[1].row,
                           found.singular[1].column}),
              testing::ElementsAre(0, 1, 1, 1));
  const kanexpr::symbolic::number told = g.number_at(found.values(0, 1).node());
  EXPECT_NE(told.value(), told.value());
  EXPECT_TRUE(limits_at(g, matrix(g, 0, 0), {}).singular.empty());
}

TEST_F(limits, are_plain_substitution_where_nothing_is_singular) {
  for (unsigned seed = 0; seed < 30; ++seed) {
    symbols s;
    random_formulas random(s, seed);
    std::vector<expression> formulas;
    matrix all(s.g, 1, 40);
    for (int i = 0; i < 40; ++i) all(0, i) = random.make(1 + i % 5).e;
    std::vector<replacement> point;
    substitution plain(s.g);
    for (const expression e : {s.a, s.q1, s.b, s.u1}) {
      if (seed % 2 == 0 && e == s.a) continue;
      point.push_back({e, s.number(static_cast<double>(evaluate(e, random.point(0))))});
      plain.replace(e, point.back().by);
    }
    const point_values found = limits_at(s.g, all, point);
    EXPECT_TRUE(found.singular.empty()) << seed << ' ' << found.singular[0].condition;
    for (int i = 0; i < 40; ++i) EXPECT_EQ(found.values(0, i), plain.in(all(0, i))) << seed << ' ' << i;
  }
}

/// Quotients of random regular functions that vanish at a point.
class removable {
public:
  explicit removable(unsigned seed) : engine_(seed) {
    for (expression each : {s.q1, s.q2}) point.push_back({each, s.number(uniform())});
  }

  expression make() {
    const expression v = vanishing(), w = vanishing();
    switch (pick(8)) {
    case 0: return regular() * sin(v) / (regular() * tan(v)) + regular();
    case 1: return regular() * (1 - cos(v)) / (v * sin(v)) - regular();
    case 2: return (exp(v) - v - 1) * regular() / (v * v);
    case 3: return 1 / v - 1 / sin(v) + regular();
    case 4: return (asin(v) - atan(v)) / (v * (1 - cos(v))) * regular();
    case 5: return sin(v) * tan(w) / (v * (exp(w) - 1) * regular());
    case 6: return (sqrt(v + 1) - 1) / log(v + 1) * regular();
    default: return (sin(v) / v - 1) / (tan(v) * v) + (power(v + 1, s.fraction(5, 3)) - 1) / v;
    }
  }

  /// Extrapolates values on the way to the point (Neville).
  real extrapolated(expression e) const {
    const real across[] = {0.7L, 0.4L};
    std::vector<real> table;
    for (int level = 0; level < 9; ++level) {
      const real step = std::ldexp(0.2L, -level);
      std::vector<real> values(static_cast<std::size_t>(s.g.symbols().size()), 0);
      for (std::size_t i = 0; i < point.size(); ++i)
        values[static_cast<std::size_t>(s.g[point[i].symbol.node()].a)] =
            s.g.number_at(point[i].by.node()).value() + step * across[i];
      table.push_back(evaluate(e, values));
      for (std::size_t i = table.size() - 1, order = 1; i-- > 0; ++order)
        table[i] = table[i + 1] + (table[i + 1] - table[i]) / (std::ldexp(1.0L, static_cast<int>(order)) - 1);
    }
    return table.front();
  }

  symbols s;
  std::vector<replacement> point;

private:
  int pick(int count) { return std::uniform_int_distribution<int>(0, count - 1)(engine_); }
  double uniform() { return std::uniform_real_distribution<double>(0.3, 1.1)(engine_); }
  expression vanishing() {
    const expression step =
        s.number(uniform()) * (s.q1 - point[0].by) + s.number(uniform()) * (s.q2 - point[1].by);
    return pick(2) == 0 ? step : step * regular();
  }
  expression regular() {
    return s.number(uniform()) * sin(s.q1 + s.number(uniform())) + cos(s.q2 * s.number(uniform())) + 1;
  }

  std::mt19937 engine_;
};

TEST(removable_singularities, have_the_values_that_evaluation_tends_to) {
  for (unsigned seed = 0; seed < 120; ++seed) {
    removable random(seed);
    const expression e = random.make();
    matrix m(random.s.g, 1, 1);
    m(0, 0) = e;
    const point_values found = limits_at(random.s.g, m, random.point);
    ASSERT_TRUE(found.singular.empty()) << seed << ' ' << found.singular[0].condition;
    ASSERT_TRUE(found.values(0, 0).is_constant());
    const real value = random.s.g.number_at(found.values(0, 0).node()).value(),
               expected = random.extrapolated(e);
    EXPECT_PRED3(are_close, value, expected, 1e-9L * (1 + std::abs(expected))) << seed;
  }
}

} // namespace
