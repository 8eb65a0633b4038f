// builds: clang++ sanitize no-exceptions
#include "symbolic/symbols.hpp"

#include <kanexpr/symbolic/printing/print.hpp>

#include <gtest/gtest.h>

namespace {

using namespace kanexpr::symbolic;

class printed : public testing::Test, protected symbols {};
using print_sum = printed;
using print_product = printed;
using print_function = printed;
using print_number = printed;
using print_matrix = printed;

TEST_F(print_sum, is_flat) {
  EXPECT_EQ(print(a - b + 2 * c), "a - b + 2*c");
  EXPECT_EQ(print(a - (b - c)), "a - b + c");
  EXPECT_EQ(print(a - (b - (c - (x - y)))), "a - b + c - x + y");
  EXPECT_EQ(print((a + b) + c), "a + b + c");
  EXPECT_EQ(print(a + 2 * (b + c)), "a + 2*(b + c)");
}

TEST_F(print_sum, starts_with_a_positive_term_where_there_is_one) {
  EXPECT_EQ(print(b - a), "b - a");
  EXPECT_EQ(print(-a + b), "b - a");
  EXPECT_EQ(print(-(a - b)), "b - a");
  EXPECT_EQ(print(-a - b), "-a - b");
  EXPECT_EQ(print(-(a + b)), "-a - b");
}

TEST_F(print_sum, ends_with_its_number) {
  EXPECT_EQ(print(1 - a), "1 - a");
  EXPECT_EQ(print(a + 1), "a + 1");
  EXPECT_EQ(print((a + 1) + (b - 3)), "a + b - 2");
  EXPECT_EQ(print(a - number(0.5)), "a - 0.5");
  EXPECT_EQ(print(-a - fraction(1, 2)), "-a - 1/2");
}

TEST_F(print_sum, gathers_like_terms) {
  EXPECT_EQ(print((a - b) + c - a), "c - b");
  EXPECT_EQ(print((2 * a + b) + 3 * a), "5*a + b");
  EXPECT_EQ(print(((a - b) + c) - ((a - b) + c)), "0");
}

TEST_F(print_product, has_powers_and_one_bar) {
  EXPECT_EQ(print(m * r * r / 4), "m*r^2/4");
  EXPECT_EQ(print(fraction(3, 4) * m * r * r), "3*m*r^2/4");
  EXPECT_EQ(print(a / b / c), "a/(b*c)");
  EXPECT_EQ(print(x / (y / z)), "x*z/y");
  EXPECT_EQ(print((x / y) / (z / a)), "a*x/(y*z)");
  EXPECT_EQ(print(1 / (4 * a)), "1/(4*a)");
  EXPECT_EQ(print(power(a, number(-3))), "1/a^3");
  EXPECT_EQ(print(a / (b * b)), "a/b^2");
  EXPECT_EQ(print((a * a * b) / (a * c)), "a*b/c");
}

TEST_F(print_product, keeps_signs_outside) {
  EXPECT_EQ(print(-(a + b) * c), "-c*(a + b)");
  EXPECT_EQ(print(-(a * a)), "-a^2");
  EXPECT_EQ(print((-a) * (-a)), "a^2");
  EXPECT_EQ(print(-1 * a), "-a");
  EXPECT_EQ(print(a - b / -c), "a + b/c");
  const expression below = b - c;
  EXPECT_EQ(print(a / below + 1 / (c - b)), "a/(b - c) - 1/(b - c)");
}

TEST_F(print_product, encloses_sums) {
  EXPECT_EQ(print((a + b) / 2), "(a + b)/2");
  EXPECT_EQ(print(fraction(2, 3) * (a - b)), "2*(a - b)/3");
  EXPECT_EQ(print((a + b) / (c - m)), "(a + b)/(c - m)");
  EXPECT_EQ(print((a + b) * (a + b)), "(a + b)^2");
  EXPECT_EQ(print(a / (2 * ((b + c) * (b + c)))), "a/(2*(b + c)^2)");
}

TEST_F(print_product, orders_its_factors) {
  EXPECT_EQ(print(3 * ((x + y) * sin(q1) * u2 * q1 * r * a)), "3*a*r*q1*u2*sin(q1)*(x + y)");
  EXPECT_EQ(print(of(kind::coordinate, "q10") * q2), "q2*q10");
  EXPECT_EQ(print(cos(q2) * sin(q2) * sin(q1)), "sin(q1)*sin(q2)*cos(q2)");
  EXPECT_EQ(print(q1_rate * q1), "q1*q1'");
}

TEST_F(print_function, has_arguments_in_parentheses) {
  EXPECT_EQ(print(sin(q1) * sin(q1)), "sin(q1)^2");
  EXPECT_EQ(print(sin(q1 - (q2 - u1))), "sin(q1 - q2 + u1)");
  EXPECT_EQ(print(sqrt(x) / sqrt(y)), "sqrt(x)/sqrt(y)");
  EXPECT_EQ(print(atan2(y, -x)), "atan2(y, -x)");
  EXPECT_EQ(print(cbrt(-x) + erf(2 * y) * wrap_to_pi(-z)), "erf(2*y)*wrap_to_pi(-z) - cbrt(x)");
  EXPECT_EQ(print(exp(-(a * x)) * abs(x) * sign(y) * log(z)), "exp(-a*x)*log(z)*abs(x)*sign(y)");
  EXPECT_EQ(print(tan(asin(a)) + acos(b) - atan(c / 2)), "tan(asin(a)) + acos(b) - atan(c/2)");
}

TEST_F(print_function, has_general_powers) {
  EXPECT_EQ(print(power(a, b)), "a^b");
  EXPECT_EQ(print(power(a, -b)), "a^(-b)");
  EXPECT_EQ(print(power(a + b, c + 1)), "(a + b)^(c + 1)");
  EXPECT_EQ(print(power(a, fraction(1, 3))), "a^(1/3)");
  EXPECT_EQ(print(power(a, number(-0.3))), "a^(-0.3)");
  EXPECT_EQ(print(power(power(a, b), c)), "(a^b)^c");
  EXPECT_EQ(print(power(a, b) * power(a, b)), "(a^b)^2");
  EXPECT_EQ(print(1 / power(a, b)), "1/a^b");
  EXPECT_EQ(print(power(number(2), x)), "2^x");
}

TEST_F(print_function, has_rates) { EXPECT_EQ(print(q1_rate * q1_rate - u1_rate), "q1'^2 - u1'"); }

TEST_F(print_number, is_exact_or_as_short_as_possible) {
  EXPECT_EQ(print(number(0)), "0");
  EXPECT_EQ(print(number(-7)), "-7");
  EXPECT_EQ(print(fraction(-6, 4)), "-3/2");
  EXPECT_EQ(print(number(0.1)), "0.1");
  EXPECT_EQ(print(number(0.1) + number(0.2)), "0.30000000000000004");
  EXPECT_EQ(print(number(1e-9) * a), "1e-09*a");
  EXPECT_EQ(print(number(-9.81) * m), "-9.81*m");
  EXPECT_EQ(print(a / number(0)), "a/0");
}

TEST_F(print_number, survives_deep_sharing) {
  expression p = a + b, s = a;
  for (int i = 0; i < 40; ++i) p *= p;
  EXPECT_EQ(print(p / c), "((a + b)^512)^2147483648/c");
  expression before = b;
  for (int i = 0; i < 60; ++i) {
    const expression next = s + before;
    before = s;
    s = next;
  }
  EXPECT_EQ(print(s), "2504730781961*a + 1548008755920*b");
}

TEST_F(print_matrix, has_aligned_columns) {
  matrix w(g, 2, 2);
  w(0, 0) = m * r * r / 4;
  w(0, 1) = a;
  w(1, 1) = -b;
  EXPECT_EQ(print(w), "[m*r^2/4, a ]\n"
                      "[0,       -b]");
  EXPECT_EQ(print(matrix(g, 1, 1)), "[0]");
  EXPECT_EQ(print(matrix()), "");
}

TEST_F(print_matrix, is_aligned_behind_a_text) {
  matrix w(g, 2, 2);
  w(0, 0) = a;
  w(1, 1) = -b;
  EXPECT_EQ(print(w, "M = "), "M = [a, 0 ]\n"
                              "    [0, -b]");
  EXPECT_EQ(print(w, "of all speeds:\nṀ = "), "of all speeds:\nṀ = [a, 0 ]\n"
                                              "    [0, -b]");
  EXPECT_EQ(print(matrix(g, 1, 1), "f = "), "f = [0]");
}

TEST_F(print_matrix, counts_the_letters_of_names_beyond_ascii) {
  matrix w(g, 2, 2);
  w(0, 0) = variable(g, {symbol_kind::parameter, "θ", 0});
  w(1, 0) = a;
  EXPECT_EQ(print(w), "[θ, 0]\n"
                      "[a, 0]");
}

} // namespace
