// builds: clang++ sanitize
#include "scrambled_formula.hpp"

#include <kanexpr/symbolic/algebra/equality.hpp>
#include <kanexpr/symbolic/algebra/forms.hpp>
#include <kanexpr/symbolic/derivatives/differentiate.hpp>
#include <kanexpr/symbolic/graph/evaluate.hpp>
#include <kanexpr/symbolic/graph/substitute.hpp>
#include <kanexpr/symbolic/linear/linear_system.hpp>
#include <kanexpr/symbolic/printing/print.hpp>

#include <gtest/gtest.h>

namespace {

using namespace kanexpr::symbolic;
using graph_evaluation::evaluate;

class comparison : public testing::Test, protected symbols {
protected:
  expression theta1 = of(kind::coordinate, "theta1"), theta2 = of(kind::coordinate, "theta2"),
             theta3 = of(kind::coordinate, "theta3"), q3 = of(kind::coordinate, "q3"),
             u3 = of(kind::speed, "u3");
  expression l1 = of(kind::parameter, "l1"), l2 = of(kind::parameter, "l2"), l3 = of(kind::parameter, "l3"),
             m1 = of(kind::parameter, "m1"), m2 = of(kind::parameter, "m2"), m3 = of(kind::parameter, "m3");
};

TEST_F(comparison, of_quotients) {
  EXPECT_EQ(compare((a * a - b * b) / (a - b), a + b), equality::equal);
  EXPECT_EQ(compare(a / b + x / y, (a * y + b * x) / (b * y)), equality::equal);
  EXPECT_EQ(compare(a / b + x / y, (a * y + b * x) / (b * x)), equality::different);
  EXPECT_EQ(compare(tan(q1 + q2), (tan(q1) + tan(q2)) / (1 - tan(q1) * tan(q2))), equality::equal);
  EXPECT_EQ(compare(sin(q1) / (cos(q1) + 1), (1 - cos(q1)) / sin(q1)), equality::equal);
  EXPECT_EQ(compare(sin(q1) / (cos(q1) + 1), tan(q1 / 2)), equality::equal);
  EXPECT_EQ(compare(sin(q1) / (cos(q1) + 1), tan(q1 / 3)), equality::different);
  EXPECT_EQ(compare(1 / (m + a * sin(q1) * sin(q1)), 1 / (m + a - a * cos(q1) * cos(q1))), equality::equal);
}

TEST_F(comparison, of_other_functions) {
  EXPECT_EQ(compare(sqrt(x) * sqrt(x) / x, number(1)), equality::equal);
  EXPECT_EQ(compare(1 / sqrt(x), sqrt(x) / x), equality::equal);
  EXPECT_EQ(compare((sqrt(x) - sqrt(y)) * (sqrt(x) + sqrt(y)), x - y), equality::equal);
  EXPECT_EQ(compare(a / (sqrt(x) - 1) + a / (sqrt(x) + 1), 2 * (a * sqrt(x)) / (x - 1)), equality::equal);
  EXPECT_EQ(compare(log(1 - sin(q1) * sin(q1)), log(cos(q1) * cos(q1))), equality::equal);
  EXPECT_EQ(compare(sin(atan2(y, x) + q1), sin(q1) * cos(atan2(y, x)) + cos(q1) * sin(atan2(y, x))),
            equality::equal);
  // true, but not proved
  EXPECT_EQ(compare(sqrt(x * x), abs(x)), equality::undecided);
  EXPECT_EQ(compare(exp(x + y), exp(x) * exp(y)), equality::undecided);
  EXPECT_EQ(compare(sin(atan2(y, x)), y / sqrt(x * x + y * y)), equality::undecided);
  EXPECT_EQ(compare(sin(asin(a / 2) + q1 - asin(a / 2)), sin(q1)), equality::equal);
  // false only for x < 0
  EXPECT_EQ(compare(abs(x), x), equality::undecided);
  EXPECT_FALSE(are_equal(abs(x), x));
  // visible numerically
  EXPECT_EQ(compare(exp(x + y), exp(x) + exp(y)), equality::different);
  EXPECT_EQ(compare(sqrt(x), x), equality::different);
  // never defined
  EXPECT_EQ(compare(sqrt(-(x * x) - 1), x), equality::undecided);
}

TEST_F(comparison, of_what_is_left_without_other_functions) {
  EXPECT_EQ(compare(sqrt(x) + sin(q1), sqrt(x) + sin(q1) + a / 1000000), equality::different);
}

TEST_F(comparison, of_decimal_numbers) {
  EXPECT_EQ(compare(number(0.5) * x, x / 2), equality::equal);
  EXPECT_EQ(compare(number(0.1) * x, x / 10), equality::different);
  EXPECT_EQ(compare((x + number(0.1)) * (x - number(0.1)) + number(0.1) * number(0.1), x * x),
            equality::different); // 0.1 * 0.1 was rounded
  EXPECT_EQ(compare(2 * (sin(number(0.1) * x) * cos(number(0.1) * x)), sin(number(0.2) * x)),
            equality::undecided);
  EXPECT_EQ(compare(number(std::numeric_limits<double>::infinity()) * x, x), equality::undecided);
}

TEST_F(comparison, of_solutions) {
  matrix w(g, 4, 4), v(g, 4, 4);
  for (int i = 0; i < 4; ++i) {
    w(i, i) = (a + (i + 1)) * (a - (i + 1)), v(i, i) = a * a - (i + 1) * (i + 1);
    w(i, (i + 1) % 4) = v(i, (i + 1) % 4) = x;
  }
  const sequence<expression> right{a, b, c, m};
  const expression first = solve(factorization(g, w), right)[0];
  EXPECT_EQ(compare((first + x) * (first - x), first * first - x * x), equality::equal);
  EXPECT_EQ(compare(first, solve(factorization(g, v), right)[0]), equality::undecided);
  EXPECT_EQ(compare(first, solve(factorization(g, v), right)[1]), equality::different);
}

TEST(scrambled_pair, is_decided) {
  int equal = 0, different = 0;
  for (unsigned seed = 0; seed < 1200; ++seed) {
    symbols s;
    scrambled_formulas random(s, seed, true);
    const bool is_spoiled = seed % 2 != 0;
    if (is_spoiled) random.spoil();
    const scrambled_formulas::pair p = random.make(3);
    bool is_apart = false;
    for (const std::vector<long double>& at : random.points()) {
      const long double value = evaluate(p.first, at);
      is_apart = is_apart || std::abs(evaluate(p.second, at) - value) > 1e-12L * (1 + std::abs(value));
    }
    ASSERT_TRUE(is_spoiled || !is_apart) << seed;
    (is_apart ? different : equal) += 1;
    EXPECT_EQ(compare(p.first, p.second), is_apart ? equality::different : equality::equal)
        << seed << ": " << print(p.first) << "\n"
        << print(p.second);
  }
  EXPECT_GT(equal, 600);
  EXPECT_GT(different, 350);
}

/// Three point masses on three massless rods in a plane: the mass matrix for the speeds, from the positions
/// of the masses, in which the angles are sums of relative ones.
TEST_F(comparison, of_two_formulations_of_a_pendulum) {
  const expression q[] = {q1, q2, q3}, u[] = {u1, u2, u3}, theta[] = {theta1, theta2, theta3};
  const expression length[] = {l1, l2, l3}, mass[] = {m1, m2, m3};
  differentiation rate(g);
  for (int i = 0; i < 3; ++i) rate.set_rate(q[i], u[i]);
  expression kinetic = number(0), x_of = number(0), y_of = number(0), angle = number(0);
  for (int i = 0; i < 3; ++i) {
    angle += q[i];
    x_of += length[i] * cos(angle), y_of += length[i] * sin(angle);
    const expression vx = rate.of(x_of), vy = rate.of(y_of);
    kinetic += mass[i] * (vx * vx + vy * vy) / 2;
  }
  // with absolute angles m_ij = l_i l_j cos(θ_i - θ_j) Σ m_k, k from max(i, j)
  substitution relative(g);
  relative.replace(theta1, q1);
  relative.replace(theta2, q1 + q2);
  relative.replace(theta3, q1 + q2 + q3);
  const auto absolute = [&](int i, int j) {
    expression outer = number(0);
    for (int k = std::max(i, j); k < 3; ++k) outer += mass[k];
    return length[i] * length[j] * outer * cos(theta[i] - theta[j]);
  };
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      expression transformed = number(0); // Tᵀ M T; the angle k changes with the speeds up to k
      for (int k = i; k < 3; ++k)
        for (int l = j; l < 3; ++l) transformed += relative.in(absolute(k, l));
      const expression entry = differentiate(differentiate(kinetic, u[i]), u[j]);
      EXPECT_EQ(compare(entry, transformed), equality::equal) << i << j;
      EXPECT_EQ(trigonometric_normal_form(entry).value, trigonometric_normal_form(transformed).value);
      EXPECT_EQ(compare(entry, transformed + m3 * l1 * l2 * cos(q2 - q3) / 1000), equality::different);
    }
}

TEST_F(comparison, of_too_many_terms) {
  expression e = sin(q1) + a;
  for (int i = 0; i < 12; ++i) e *= e / 8 + sin(q2 + (i + 1) * q1);
  EXPECT_EQ(compare(e * (e + 1), e * e + e), equality::undecided);
  EXPECT_EQ(compare(e * (e + 1), e * e - e), equality::different); // numerically
  EXPECT_EQ(compare((a + b) * (x + y), a * x + a * y + b * x + b * y, 3), equality::undecided);
  EXPECT_EQ(compare((a + b) * (x + y), a * x + a * y + b * x + b * y, 4), equality::equal);
}

} // namespace
