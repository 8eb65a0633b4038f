// builds: clang++ sanitize no-exceptions
#include "symbolic/symbols.hpp"

#include <kanexpr/symbolic/linear/solve.hpp>
#include <kanexpr/symbolic/printing/print.hpp>
#include <kanexpr/symbolic/printing/short_text.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <string>

namespace {

using namespace kanexpr::symbolic;

class printed : public testing::Test, protected symbols {};
using print_sum = printed;
using print_product = printed;
using print_function = printed;
using print_number = printed;
using print_matrix = printed;
using print_parts = printed;

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

TEST_F(print_parts, have_names_in_a_long_text) {
  const expression part = a * cos(q1) + b * sin(q1 + q2), e = part * u1 + c / part;
  EXPECT_EQ(print(e), "c/(a*cos(q1) + b*sin(q1 + q2)) + u1*(a*cos(q1) + b*sin(q1 + q2))");
  const std::size_t length = print(e).size();
  EXPECT_EQ(print(e, length), print(e));
  EXPECT_EQ(print(e, length - 1), "c/z1 + u1*z1\n"
                                  "where\n"
                                  "  z1 = a*cos(q1) + b*sin(q1 + q2)");
  EXPECT_EQ(print(a + b, 0), "a + b");
  matrix w(g, 2, 2);
  w(0, 0) = e, w(0, 1) = part, w(1, 1) = sqrt(part * part + 1);
  EXPECT_EQ("M = " + print(w, 0).substr(0, 30), print(w, "M = ", 0).substr(0, 34));
  EXPECT_EQ(print(w, "M = ", 0), "M = [c/z1 + u1*z1, z1            ]\n"
                                 "    [0,            sqrt(z1^2 + 1)]\n"
                                 "where\n"
                                 "  z1 = a*cos(q1) + b*sin(q1 + q2)");
}

TEST_F(print_parts, are_numbered_as_they_are_needed) {
  const expression late = exp(a + b + c + m + r + x), early = cos(a - b - c - m - r - x);
  const expression outer = late * late + early + late / early;
  EXPECT_EQ(print(early * outer + late * outer, 0), "z1*z3 + z2*z3\n"
                                                    "where\n"
                                                    "  z1 = cos(a - b - c - m - r - x)\n"
                                                    "  z2 = exp(a + b + c + m + r + x)\n"
                                                    "  z3 = z1 + z2/z1 + z2^2");
}

TEST_F(print_parts, have_no_name_of_a_symbol) {
  const expression taken = of(kind::input, "z_2"), part = a * cos(q1) + b * sin(q1 + taken);
  EXPECT_EQ(print(part / (part + z), 0), "zz1/(z + zz1)\n"
                                         "where\n"
                                         "  zz1 = a*cos(q1) + b*sin(q1 + z_2)");
}

TEST_F(print_parts, are_matrices_and_solutions) {
  matrix w(g, 4, 4);
  kanexpr::base::sequence<expression> right;
  for (int i = 0; i < 16; ++i) w.entries[i] = sin(i * a) + b;
  for (int i = 0; i < 4; ++i) right.push(cos(i * c));
  const expression factors = factorization(g, w);
  const auto once = solve(factors, right), twice = solve_transposed(factors, once);
  EXPECT_EQ(print(once[0] + once[1] + twice[2], 0),
            "z2[1] + z2[2] + solve(transpose(z1), [z2[1], z2[2], z2[3], z2[4]])[3]\n"
            "where\n"
            "  z1 = [[b, b + sin(a), b + sin(2*a), b + sin(3*a)], "
            "[b + sin(4*a), b + sin(5*a), b + sin(6*a), b + sin(7*a)], "
            "[b + sin(8*a), b + sin(9*a), b + sin(10*a), b + sin(11*a)], "
            "[b + sin(12*a), b + sin(13*a), b + sin(14*a), b + sin(15*a)]]\n"
            "  z2 = solve(z1, [1, cos(c), cos(2*c), cos(3*c)])");
}

TEST_F(print_parts, keep_deep_sharing_short) {
  expression e = a + b * q1;
  for (int i = 0; i < 60; ++i) e = sin(e) * e + u1 * e / (1 + e * e); // 5^60 symbols if written in full
  const std::string text = print(e);
  EXPECT_LT(text.size(), 5000U);
  EXPECT_NE(text.find("\n  z59 = u1*z58/(z58^2 + 1) + sin(z58)*z58"), std::string::npos) << text;
  EXPECT_EQ(print(e, 1000), print(e, 0));
  EXPECT_LT(print_in_sentence(e).size(), 64U);
  EXPECT_EQ(print_in_sentence(a / b), "a/b");
  expression product = a + b;
  for (int i = 0; i < 60; ++i) product = (product + i) * product * cos(product);
  EXPECT_LT(short_text(g, product.node()).view().size(), 64U);
}

TEST_F(print_parts, limit_the_length_of_lines_and_the_depth) {
  expression sum = a, nested = a;
  for (int i = 0; i < 400; ++i) sum = sum + cos(i * q1);
  for (int i = 0; i < 5000; ++i) nested = sin(nested + b);
  for (const std::string& text : {print(sum, 0), print(nested)}) {
    std::size_t longest = 0, start = 0;
    for (std::size_t end = 0; end != std::string::npos; start = end + 1) {
      end = text.find('\n', start);
      longest = (std::max)(longest, (end == std::string::npos ? text.size() : end) - start);
    }
    EXPECT_LT(longest, 500U);
  }
}

} // namespace
