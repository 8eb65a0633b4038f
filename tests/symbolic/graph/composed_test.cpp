// builds: clang++
// Functions that are composed of others, and selections.
#include "evaluate_graph.hpp"
#include "symbolic/symbols.hpp"

#include <kanexpr/symbolic/derivatives/accumulate.hpp>
#include <kanexpr/symbolic/derivatives/evaluate_rate.hpp>
#include <kanexpr/symbolic/graph/compose.hpp>
#include <kanexpr/symbolic/printing/latex.hpp>
#include <kanexpr/symbolic/printing/print.hpp>
#include <kanexpr/symbolic/sizes/equal_units.hpp>
#include <kanexpr/symbolic/sizes/finiteness.hpp>
#include <kanexpr/symbolic/sizes/magnitudes.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace {

using namespace kanexpr::symbolic;

constexpr double infinity = std::numeric_limits<double>::infinity(),
                 nan = std::numeric_limits<double>::quiet_NaN();

class composed : public testing::Test, protected symbols {
protected:
  double at(expression e, double x_is, double y_is = 0.5, double z_is = -0.25) const {
    return values_at(g, {e.node()}, [&](int id) {
      return id == x.node() ? x_is : id == y.node() ? y_is : id == z.node() ? z_is : 2.0;
    })[0];
  }
};

TEST_F(composed, is_what_it_stands_for) {
  EXPECT_DOUBLE_EQ(at(hypot(x, y), 1.2), 1.3);
  EXPECT_EQ(at((min)(x, y), 0.4), 0.4);
  EXPECT_EQ(at((min)(x, y), 0.6), 0.5);
  EXPECT_EQ(at((max)(x, y), 0.4), 0.5);
  EXPECT_EQ(at((max)(x, y), 0.6), 0.6);
  for (const double value : {-1.0, -0.25, 0.0, 0.5, 7.0})
    EXPECT_EQ(at(clamp(x, z, y), value), std::fmin(std::fmax(value, -0.25), 0.5));
  EXPECT_EQ(at(if_positive(x, y, z), 1e-300), 0.5);
  EXPECT_EQ(at(if_positive(x, y, z), 0), -0.25);
  EXPECT_EQ(at(if_positive(x, y, z), -infinity), -0.25);
}

TEST_F(composed, words_are_in_their_order) {
  int place = 0;
  for (const composite_signature& each : compositions) {
    EXPECT_EQ(static_cast<int>(each.is), place++) << each.name;
    EXPECT_STREQ(signature_of(each.is).name, each.name);
  }
}

TEST_F(composed, selection_hands_on_what_is_no_number) {
  for (const expression e :
       {(min)(x, y), (max)(x, y), (min)(y, x), (max)(y, x), clamp(x, z, y), clamp(y, x, z), clamp(y, z, x),
        if_positive(x, y, z), if_positive(x, y, number(0)), if_positive(x, number(0), y),
        if_positive(y, x, z)})
    EXPECT_TRUE(std::isnan(at(e, nan))) << print(e);
  EXPECT_EQ(at(if_positive(z, x, y), nan), 0.5);
  EXPECT_EQ(at((min)(x, y), infinity), 0.5);
  EXPECT_EQ(at((max)(x, y), -infinity), 0.5);
}

TEST_F(composed, selection_is_simplified) {
  EXPECT_EQ(if_positive(x, y, y), y);
  EXPECT_EQ(if_positive(number(2), y, z), y);
  EXPECT_EQ(if_positive(number(0), y, z), z);
  EXPECT_EQ(if_positive(number(-1), y, z), z);
  EXPECT_EQ((min)(number(2), number(3)), number(2));
  EXPECT_EQ(clamp(number(5), number(2), number(3)), number(3));
  EXPECT_EQ(if_positive(x, -y, -z), -(if_positive(x, y, z)));
  EXPECT_EQ(if_positive(x, if_positive(x, y, number(0)), z), if_positive(x, y, z));
}

TEST_F(composed, selection_is_printed) {
  EXPECT_EQ(print(if_positive(x, y, z)), "if_positive(x, y, z)");
  EXPECT_EQ(print(if_positive(x + y, number(0), -2 * z) * a), "-a*if_positive(x + y, 0, 2*z)");
  EXPECT_EQ(print(a - 2 * if_positive(x, y + 1, z)), "a - 2*if_positive(x, y + 1, z)");
  EXPECT_EQ(print(hypot(x, y)), "sqrt(x^2 + y^2)");
  EXPECT_EQ(latex(if_positive(x, y, z)), R"(\operatorname{if}\left(x > 0, y, z\right))");
  EXPECT_EQ(latex(a * if_positive(x, y, number(0))), R"(a \operatorname{if}\left(x > 0, y, 0\right))");
}

TEST_F(composed, selection_is_differentiated_where_it_goes) {
  const expression e = if_positive(x, y * sin(x), z * x * x);
  accumulation reverse(g, {e});
  reverse.seed(e, number(1));
  reverse.run();
  for (const double value : {-0.7, 0.7}) {
    const double by_x = value > 0 ? 0.5 * std::cos(value) : -0.5 * value;
    EXPECT_DOUBLE_EQ(at(differentiate(e, x), value), by_x);
    EXPECT_DOUBLE_EQ(at(reverse.by(x), value), by_x);
    EXPECT_DOUBLE_EQ(at(reverse.by(y), value), value > 0 ? std::sin(value) : 0);
    EXPECT_DOUBLE_EQ(at(reverse.by(z), value), value > 0 ? 0 : value * value);
    rate_evaluation rate(g, {e.node()});
    rate.at([&](int id) {
      return id == x.node() ? value_and_rate{value, 1} : value_and_rate{id == y.node() ? 0.5 : -0.25, 0};
    });
    EXPECT_DOUBLE_EQ(rate[e.node()].rate, by_x);
  }
  EXPECT_EQ(print(differentiate(hypot(x, y), x)), "x/sqrt(x^2 + y^2)");
}

TEST_F(composed, derivative_at_a_tie_is_that_of_the_second) {
  const expression least = differentiate((min)(x, y), x), most = differentiate((max)(x, y), x),
                   between = differentiate(clamp(x, z, y), x);
  EXPECT_EQ(at(least, 0.5), 0);
  EXPECT_EQ(at(most, 0.5), 0);
  EXPECT_EQ(at(differentiate((min)(x, y), y), 0.5), 1);
  EXPECT_EQ(at(between, 0.5), 0);
  EXPECT_EQ(at(between, -0.25), 0);
  EXPECT_EQ(at(between, 0.25), 1);
}

/// At x < 0 a root has neither a value nor a slope, and at x = 0 its slope is infinite.
TEST_F(composed, what_is_left_out_does_not_matter) {
  const expression e = if_positive(x, sqrt(x) * y, z / x + x);
  const expression root = if_positive(x, y * sqrt(x), x * y);
  accumulation reverse(g, {root});
  reverse.seed(root, number(3));
  reverse.run();
  EXPECT_EQ(at(root, 0), 0);
  EXPECT_EQ(at(root, -4), -2);
  EXPECT_EQ(at(root, 4), 1);
  for (const double value : {-4.0, 0.0}) {
    EXPECT_EQ(at(differentiate(root, x), value), 0.5);
    EXPECT_EQ(at(reverse.by(x), value), 1.5);
    EXPECT_EQ(at(reverse.by(y), value), 3 * value);
  }
  EXPECT_EQ(at(reverse.by(x), 4), 3 * 0.5 / 4);
  EXPECT_TRUE(std::isnan(at(e, 0)));
}

TEST_F(composed, selection_has_the_size_and_the_unit_of_its_branches) {
  const expression e = if_positive(x, y, z);
  evaluation value(g, {e.node()});
  value.at([&](int id) { return id == x.node() ? 1.0 : id == y.node() ? -3.0 : 5.0; });
  EXPECT_EQ(magnitudes(g, value)[e.node()], 3);
  EXPECT_TRUE(equal_units(g, {e.node()}).have_same_unit(y.node(), z.node()));
  EXPECT_FALSE(equal_units(g, {e.node()}).have_same_unit(x.node(), z.node()));
  EXPECT_TRUE(equal_units(g, {(min)(x, z).node()}).have_same_unit(x.node(), z.node()));
}

TEST_F(composed, result_is_looked_at_where_a_branch_may_fail) {
  const expression sure = if_positive(x, y, z), quotient = y / z, unsure = if_positive(x, quotient, z);
  const auto looked_at = [this](const sequence<int>& outputs) {
    return finiteness(g, outputs, live_list(g, outputs), {}).outputs_to_check().size();
  };
  EXPECT_EQ(looked_at({sure.node()}), 0);
  // the quotient may be infinite while the selection is finite, and vice versa
  EXPECT_EQ(looked_at({unsure.node(), quotient.node()}), 2);
}

TEST_F(composed, selection_counts_as_a_comparison) {
  EXPECT_EQ(cost_of(g, {if_positive(x, y, z).node()}).additions, 3);
  EXPECT_EQ(cost_of(g, {(min)(x, y).node()}).additions, 4);
}

constexpr double constant_minimum() {
  graph g;
  const expression x = variable(g, {symbol_kind::input, "x", 0});
  const expression e = (min)(x, x * x);
  return values_at(g, {e.node()}, [](int) { return 0.5; })[0];
}
static_assert(constant_minimum() == 0.25);

} // namespace
