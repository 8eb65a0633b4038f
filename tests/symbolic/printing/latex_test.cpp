// builds: clang++ sanitize
#include "symbolic/symbols.hpp"

#include <kanexpr/symbolic/printing/latex.hpp>

#include <gtest/gtest.h>

namespace {

using namespace kanexpr::symbolic;

class typeset : public testing::Test, protected symbols {};
using latex_names = typeset;
using latex_sum = typeset;
using latex_product = typeset;
using latex_function = typeset;
using latex_number = typeset;
using latex_matrix = typeset;

TEST_F(latex_names, have_subscripts) {
  const auto named = [this](const char* name) { return latex(of(kind::parameter, name)); };
  EXPECT_EQ(named("q"), "q");
  EXPECT_EQ(named("q1"), "q_1");
  EXPECT_EQ(named("q12"), "q_{12}");
  EXPECT_EQ(named("Ixx1"), R"(\mathrm{Ixx}_1)");
  EXPECT_EQ(named("I_xx"), R"(I_{\mathrm{xx}})");
  EXPECT_EQ(named("theta2"), R"(\theta_2)");
  EXPECT_EQ(named("omega"), R"(\omega)");
  EXPECT_EQ(named("Omega_s"), R"(\Omega_s)");
  EXPECT_EQ(named("l_alpha"), R"(l_{\alpha})");
  EXPECT_EQ(named("q1dot"), R"(q_{\mathrm{1dot}})");
  EXPECT_EQ(named("Link<3>"), R"(\mathrm{Link}_3)");
  EXPECT_EQ(named("x_1_2"), R"(x_{\mathrm{1,2}})");
  EXPECT_EQ(latex(q1_rate), R"(\dot{q}_1)");
  EXPECT_EQ(latex(u1_rate * u1_rate), R"(\dot{u}_1^{2})");
  EXPECT_EQ(latex(of(kind::input, "theta1'")), R"(\dot{\theta}_1)");
  EXPECT_EQ(latex(of(kind::input, "x''")), R"(\ddot{x})");
  EXPECT_EQ(latex(of(kind::speed_rate, "omega12")), R"(\dot{\omega}_{12})");
}

TEST_F(latex_sum, is_flat) {
  EXPECT_EQ(latex(a - b + 2 * c), "a - b + 2 c");
  EXPECT_EQ(latex(a - (b - c)), "a - b + c");
  EXPECT_EQ(latex(-a - b), "-a - b");
  EXPECT_EQ(latex(1 - a), "1 - a");
  EXPECT_EQ(latex(-(a - b)), "b - a");
  EXPECT_EQ(latex(a + 2 * (b + c)), R"(a + 2 \left(b + c\right))");
}

TEST_F(latex_product, has_fractions) {
  EXPECT_EQ(latex(m * r * r / 4), R"(\frac{m r^{2}}{4})");
  EXPECT_EQ(latex(-(m * r) / 2), R"(-\frac{m r}{2})");
  EXPECT_EQ(latex(a / b / c), R"(\frac{a}{b c})");
  EXPECT_EQ(latex(x / (y / z)), R"(\frac{x z}{y})");
  EXPECT_EQ(latex(1 / (4 * a)), R"(\frac{1}{4 a})");
  EXPECT_EQ(latex(power(a, number(-3))), R"(\frac{1}{a^{3}})");
  EXPECT_EQ(latex((a + b) / (c - m)), R"(\frac{a + b}{c - m})");
  EXPECT_EQ(latex((a + b) / 2), R"(\frac{a + b}{2})");
  EXPECT_EQ(latex(fraction(2, 3) * (a + b)), R"(\frac{2 \left(a + b\right)}{3})");
  EXPECT_EQ(latex(1 / ((a + b) * (a + b))), R"(\frac{1}{\left(a + b\right)^{2}})");
  EXPECT_EQ(latex(1 / (a + 1 / b)), R"(\frac{1}{a + \frac{1}{b}})");
}

TEST_F(latex_product, encloses_sums) {
  EXPECT_EQ(latex(-(a + b) * c), R"(-c \left(a + b\right))");
  EXPECT_EQ(latex((a + b) * (x + y) / r), R"(\frac{\left(a + b\right) \left(x + y\right)}{r})");
  EXPECT_EQ(latex(-(a * a)), "-a^{2}");
}

TEST_F(latex_function, leaves_out_parentheses_where_the_argument_is_clear) {
  EXPECT_EQ(latex(sin(q1)), R"(\sin q_1)");
  EXPECT_EQ(latex(sin(q1 + q2)), R"(\sin\left(q_1 + q_2\right))");
  EXPECT_EQ(latex(sin(2 * q1)), R"(\sin\left(2 q_1\right))");
  EXPECT_EQ(latex(sin(q1) * cos(q2)), R"(\sin q_1 \cos q_2)");
  EXPECT_EQ(latex(sin(q1) * (a + b)), R"(\sin\left(q_1\right) \left(a + b\right))");
  EXPECT_EQ(latex(sin(q1) * exp(x)), R"(\sin\left(q_1\right) e^{x})");
  EXPECT_EQ(latex(sin(q1) * sin(q1) - 1), R"(\sin^{2} q_1 - 1)");
  EXPECT_EQ(latex(a / (cos(q1) * cos(q1))), R"(\frac{a}{\cos^{2} q_1})");
  EXPECT_EQ(latex(q1_rate * tan(q2) / cos(q1)), R"(\frac{\dot{q}_1 \tan q_2}{\cos q_1})");
}

TEST_F(latex_function, has_the_names_of_mathematics) {
  EXPECT_EQ(latex(sqrt(a + b) / sqrt(c)), R"(\frac{\sqrt{a + b}}{\sqrt{c}})");
  EXPECT_EQ(latex(abs(x) * abs(x) * abs(x)), R"(\left|x\right|^{3})");
  EXPECT_EQ(latex(exp(-x) * log(y)), R"(e^{-x} \ln y)");
  EXPECT_EQ(latex(exp(x) * exp(x)), R"(\left(e^{x}\right)^{2})");
  EXPECT_EQ(latex(asin(x)), R"(\arcsin x)");
  EXPECT_EQ(latex(sinh(x) + cosh(y)), R"(\sinh x + \cosh y)");
  EXPECT_EQ(latex(tanh(x)), R"(\tanh x)");
  EXPECT_EQ(latex(acos(x)), R"(\arccos x)");
  EXPECT_EQ(latex(atan(-x / 2)), R"(-\arctan\left(\frac{x}{2}\right))");
  EXPECT_EQ(latex(atan2(y, x)), R"(\operatorname{atan2}\left(y, x\right))");
  EXPECT_EQ(latex(sign(x)), R"(\operatorname{sign} x)");
  EXPECT_EQ(latex(cbrt(x + y)), R"(\sqrt[3]{x + y})");
  EXPECT_EQ(latex(cbrt(x) * cbrt(x)), R"(\sqrt[3]{x}^{2})");
  EXPECT_EQ(latex(erf(x)), R"(\operatorname{erf} x)");
  EXPECT_EQ(latex(wrap_to_pi(x)), R"(\operatorname{wrap}_{\pi} x)");
}

TEST_F(latex_function, has_general_powers) {
  EXPECT_EQ(latex(power(a, b)), "a^{b}");
  EXPECT_EQ(latex(power(a, -b)), "a^{-b}");
  EXPECT_EQ(latex(power(a + b, fraction(1, 3))), R"(\left(a + b\right)^{\frac{1}{3}})");
  EXPECT_EQ(latex(power(power(a, b), c)), R"(\left(a^{b}\right)^{c})");
  EXPECT_EQ(latex(power(a, b) * power(a, b)), R"(\left(a^{b}\right)^{2})");
  EXPECT_EQ(latex(power(sin(q1), a)), R"(\sin^{a}\left(q_1\right))");
  EXPECT_EQ(latex(power(exp(x), a)), R"(\left(e^{x}\right)^{a})");
  EXPECT_EQ(latex(power(fraction(1, 2), x)), R"(\left(\frac{1}{2}\right)^{x})");
  EXPECT_EQ(latex(3 * power(number(2), x)), R"(3 \cdot 2^{x})");
  EXPECT_EQ(latex(power(number(1e-5), x)), R"(\left(10^{-5}\right)^{x})");
}

TEST_F(latex_number, is_typeset) {
  EXPECT_EQ(latex(number(0)), "0");
  EXPECT_EQ(latex(fraction(-1, 3)), R"(-\frac{1}{3})");
  EXPECT_EQ(latex(number(-0.25) * a), "-0.25 a");
  EXPECT_EQ(latex(number(1.5e-7) * a), R"(1.5 \cdot 10^{-7} a)");
  EXPECT_EQ(latex(number(1e300)), "10^{300}");
  EXPECT_EQ(latex(a / number(0)), R"(\frac{a}{0})");
}

TEST_F(latex_matrix, is_in_brackets) {
  matrix w(g, 2, 2);
  w(0, 0) = a / 2;
  w(0, 1) = sin(q1);
  w(1, 1) = -b;
  EXPECT_EQ(latex(w), "\\begin{bmatrix}\n\\frac{a}{2} & \\sin q_1 \\\\\n0 & -b\n\\end{bmatrix}");
}

TEST_F(latex_matrix, names_parts_of_a_long_text) {
  const expression part = a * cos(q1) + b * sin(q1 + q2), e = part * u1 + c / sin(part);
  EXPECT_EQ(latex(e, 0), "\\begin{aligned}\n& \\frac{c}{\\sin z_1} + u_1 z_1 \\\\\n& \\text{where} \\\\\n"
                         "z_1 &= a \\cos q_1 + b \\sin\\left(q_1 + q_2\\right)\n\\end{aligned}");
  EXPECT_EQ(latex(e, latex(e).size()), latex(e));
  const kanexpr::symbolic::text_with_parts each = latex_each({e, part, a}, 0);
  EXPECT_EQ(each.expressions[1], "z_1");
  EXPECT_EQ(each.parts.size(), 1U);
  EXPECT_TRUE(latex_each({e, part, a}).parts.empty());
  expression deep = a + b * q1;
  for (int i = 0; i < 60; ++i) deep = sin(deep) * deep + u1 * deep / (1 + deep * deep);
  EXPECT_LT(latex(deep).size(), 10000U);
  EXPECT_NE(latex(deep).find("\nz_{59} &= "), std::string::npos);
}

} // namespace
