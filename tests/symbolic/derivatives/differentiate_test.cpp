// builds: clang++ sanitize
#include "symbolic/random_formula.hpp"

#include <kanexpr/symbolic/derivatives/accumulate.hpp>
#include <kanexpr/symbolic/derivatives/jacobian.hpp>
#include <kanexpr/symbolic/derivatives/jacobian_modes.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace {

using namespace kanexpr::symbolic;
using graph_evaluation::are_close;
using graph_evaluation::evaluate;
using real = long double;
using complex = std::complex<real>;

class differentiate_each : public testing::Test, protected symbols {};
using total_time_derivative = differentiate_each;

/// The derivative of e along `direction`, by an imaginary step.
real complex_step(expression e, const std::vector<real>& at, const std::vector<real>& direction) {
  constexpr real step = 1e-25L;
  std::vector<complex> values;
  for (std::size_t i = 0; i < at.size(); ++i) values.emplace_back(at[i], step * direction[i]);
  return evaluate(e, values).imag() / step;
}

real central_difference(expression e, std::vector<real> at, const std::vector<real>& direction) {
  constexpr real step = 1e-6L;
  for (std::size_t i = 0; i < at.size(); ++i) at[i] += step * direction[i];
  const real above = evaluate(e, at);
  for (std::size_t i = 0; i < at.size(); ++i) at[i] -= 2 * step * direction[i];
  return (above - evaluate(e, at)) / (2 * step);
}

std::vector<real> along(std::size_t size, int axis) {
  std::vector<real> direction(size, 0);
  direction[static_cast<std::size_t>(axis)] = 1;
  return direction;
}

TEST(derivatives, agree_with_an_imaginary_step_and_with_reverse_accumulation) {
  for (unsigned seed = 0; seed < 30; ++seed) {
    symbols s;
    random_formulas random(s, seed, true);
    for (int i = 0; i < 40; ++i) {
      const expression e = random.make(1 + i % 4).e;
      accumulation reverse(s.g, {e});
      reverse.seed(e, s.number(1));
      reverse.run();
      for (const expression by : {s.a, s.b, s.q1, s.u1}) {
        const expression forward = differentiate(e, by);
        const int axis = s.g[by.node()].a;
        for (std::size_t p = 0; p < 2; ++p) {
          const std::vector<real>& at = random.point(p);
          const real expected = complex_step(e, at, along(at.size(), axis));
          const real tolerance = 1e-11L * (1 + std::abs(expected));
          ASSERT_PRED3(are_close, evaluate(forward, at), expected, tolerance)
              << seed << ' ' << i << ' ' << axis;
          ASSERT_PRED3(are_close, evaluate(reverse.by(by), at), expected, tolerance)
              << seed << ' ' << i << ' ' << axis;
        }
      }
    }
  }
}

TEST_F(differentiate_each, function_by_an_imaginary_step) {
  std::vector<real> at(static_cast<std::size_t>(g.symbols().size()), 0.3L);
  const std::vector<real> by_x = along(at.size(), g[x.node()].a);
  at[static_cast<std::size_t>(g[y.node()].a)] = 1.7L;
  for (const expression e : {-x,
                             x + y,
                             x - y,
                             y - x,
                             x * y,
                             x / y,
                             y / x,
                             power(x, y),
                             power(y, x),
                             sqrt(x),
                             sin(x),
                             cos(x),
                             tan(x),
                             asin(x),
                             acos(x),
                             atan(x),
                             exp(x),
                             log(x),
                             sinh(x),
                             cosh(x),
                             tanh(x),
                             power(x, number(-3)),
                             power(x, number(0.3)),
                             power(x, fraction(3, 2)),
                             sin(x) / (x * x + y),
                             y + c})
    EXPECT_PRED3(are_close, evaluate(differentiate(e, x), at), complex_step(e, at, by_x), 1e-15L);
}

/// Components of a vector rotated by x, with both signs and both orders; the vector also depends on x.
TEST_F(differentiate_each, turned_component_forward_and_reverse) {
  const std::vector<real> at(static_cast<std::size_t>(g.symbols().size()), 0.3L);
  std::vector<real> apart = at;
  for (std::size_t i = 0; i < apart.size(); ++i) apart[i] += 0.1L * static_cast<real>(i);
  const expression angle = x * y, s = sin(angle), co = cos(angle), first = a + x, second = b * x;
  for (const expression e :
       {co * a - s * b, co * a + s * b, s * a + co * b, s * a - co * b, co * first - s * second,
        co * first + s * second, s * first + co * second, first * s - second * co,
        (co * first - s * second) * (s * first + co * second), co * first - s * second + co * first}) {
    accumulation reverse(g, {e});
    reverse.seed(e, number(1));
    reverse.run();
    for (const expression by : {x, y, a, b}) {
      const real expected = complex_step(e, apart, along(apart.size(), g[by.node()].a));
      EXPECT_PRED3(are_close, evaluate(differentiate(e, by), apart), expected, 1e-15L);
      EXPECT_PRED3(are_close, evaluate(reverse.by(by), apart), expected, 1e-15L);
    }
  }
}

TEST_F(differentiate_each, turned_component_is_the_other_one) {
  const expression along_x = cos(x) * a - sin(x) * b, across = sin(x) * a + cos(x) * b;
  EXPECT_EQ(differentiate(along_x, x), -across);
  EXPECT_EQ(differentiate(across, x), along_x);
}

TEST_F(differentiate_each, function_with_corners_by_differences) {
  for (const real value : {-0.7L, 0.4L}) {
    std::vector<real> at(static_cast<std::size_t>(g.symbols().size()), value);
    at[static_cast<std::size_t>(g[y.node()].a)] = -1.2L;
    const std::vector<real> by_x = along(at.size(), g[x.node()].a);
    for (const expression e :
         {abs(x), sign(x), atan2(x, y), atan2(y, x), abs(x * x - y) * sign(x * y), x * sign(x), cbrt(x),
          cbrt(x * y) * x, erf(x), erf(x - y) / x, wrap_to_pi(x), wrap_to_pi(20 * x * y) * x})
      EXPECT_PRED3(are_close, evaluate(differentiate(e, x), at), central_difference(e, at, by_x), 1e-10L);
  }
}

TEST_F(differentiate_each, function_without_complex_values_in_closed_form) {
  EXPECT_EQ(differentiate(cbrt(x), x), 1 / (3 * (cbrt(x) * cbrt(x))));
  EXPECT_EQ(differentiate(erf(x), x), number(2 / std::sqrt(std::acos(-1.0))) * exp(-(x * x)));
  EXPECT_EQ(differentiate(wrap_to_pi(x * y), x), y);
  EXPECT_EQ(differentiate(atan2(x, y), x), y / (x * x + y * y));
  EXPECT_EQ(differentiate(atan2(x, y), y), -(x / (x * x + y * y)));
}

TEST_F(differentiate_each, is_simple) {
  EXPECT_EQ(differentiate(a * x + b, x), a);
  EXPECT_EQ(differentiate(x * x, x), 2 * x);
  EXPECT_EQ(differentiate(sin(q1), q1), cos(q1));
  EXPECT_EQ(differentiate(cos(q1), q1), -sin(q1));
  EXPECT_EQ(differentiate(exp(a), x), number(0));
  EXPECT_EQ(differentiate(sign(x), x), number(0));
  EXPECT_EQ(differentiate(abs(x), x), sign(x));
}

TEST_F(differentiate_each, output_of_an_accumulation) {
  const expression first = x * y;
  accumulation both(g, {first, x});
  both.seed(first, a);
  both.seed(x, b);
  both.run();
  EXPECT_EQ(both.by(x), a * y + b);
  EXPECT_EQ(both.by(y), a * x);
  EXPECT_EQ(both.by(z), number(0));
  both.restart();
  both.seed(x, b);
  both.run();
  EXPECT_EQ(both.by(x), b);
  EXPECT_EQ(both.by(y), number(0));
}

TEST_F(differentiate_each, output_with_a_part_held) {
  const expression held = x * y, other = held * a + x;
  accumulation back(g, {other});
  back.hold(held);
  back.seed(other, number(1));
  back.run();
  EXPECT_EQ(back.by(x), number(1));
  EXPECT_EQ(back.by(a), held);
  EXPECT_EQ(back.by(y), number(0));
}

TEST_F(differentiate_each, symbol_in_the_mode_that_visits_fewer_operations) {
  // all outputs depend on x through many operations; only the last operation of one output depends on y
  const expression start = sin(exp(x * a) + z);
  const sequence<int> one = nodes_of(sequence<expression>{start * b * y});
  const jacobian_modes gradient(g, one, {x, a, b, z, y}, {});
  EXPECT_LT(gradient.by_both(), gradient.by_forward());
  EXPECT_FALSE(gradient.is_forward(0));
  const expression next = start * b;
  const sequence<int> several = nodes_of(sequence<expression>{next * y, next * next, next * z, sin(next)});
  const jacobian_modes column(g, several, {x}, {});
  EXPECT_TRUE(column.is_forward(0));
  const jacobian_modes all(g, several, {x, a, b, z, y}, {}), held(g, several, {x, a, b, z, y}, {next});
  EXPECT_LT(held.by_forward(), all.by_forward());
  EXPECT_LT(held.by_both(), all.by_both());
}

// More than 64 symbols, and nodes that depend on few of them.
TEST_F(differentiate_each, symbol_that_a_row_depends_on) {
  constexpr int count = 150;
  sequence<expression> by, rows;
  for (int i = 0; i < count; ++i) by.push(of(kind::coordinate, ("p" + std::to_string(i)).c_str()));
  for (int i = 0; i < count; ++i) {
    const expression turned =
        sum_of_products(sin(by[i]), by[(i + 1) % count], cos(by[i]), by[(i + 70) % count]);
    rows.push(i % 2 == 0 ? turned : turned * -by[(i + 71) % count]);
  }
  const matrix all = forward_jacobian(g, rows, by);
  for (int i = 0; i < count; ++i)
    for (int j = 0; j < count; ++j) {
      const int distance = (j - i + count) % count;
      const bool depends = distance < 2 || distance == 70 || (distance == 71 && i % 2 != 0);
      ASSERT_EQ(!all(i, j).is_zero(), depends) << i << ", " << j;
      ASSERT_EQ(all(i, j), differentiate(rows[i], by[j])) << i << ", " << j;
    }
}

TEST_F(total_time_derivative, follows_every_rate) {
  differentiation d(g);
  d.set_rate(q1, q1_rate);
  d.set_rate(u1, u1_rate);
  EXPECT_EQ(d.of(q1), q1_rate);
  EXPECT_EQ(d.of(m * r), number(0));
  EXPECT_EQ(d.of(sin(q1)), cos(q1) * q1_rate);
  const expression e = m * u1 * u1 * power(cos(q1), number(3)) / (r + sin(q1 * u1));
  std::vector<real> at, direction;
  for (int i = 0; i < g.symbols().size(); ++i) at.push_back(0.4L + 0.1L * i), direction.push_back(0);
  const auto place = [this](expression symbol) { return static_cast<std::size_t>(g[symbol.node()].a); };
  direction[place(q1)] = at[place(q1_rate)];
  direction[place(u1)] = at[place(u1_rate)];
  EXPECT_PRED3(are_close, evaluate(d.of(e), at), complex_step(e, at, direction), 1e-15L);
}

TEST_F(total_time_derivative, is_cheap_where_much_is_shared) {
  expression e = q1;
  for (int i = 0; i < 200; ++i) e = sin(e) * cos(e) + e;
  const int before = g.size();
  differentiation d(g);
  d.set_rate(q1, q1_rate);
  d.of(e);
  EXPECT_LT(g.size(), before + 200 * 10);
}

} // namespace
