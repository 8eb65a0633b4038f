// builds: clang++
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/functions.hpp>
#include <kanexpr/symbolic/sizes/equal_units.hpp>

#include <gtest/gtest.h>

namespace {

using namespace kanexpr::symbolic;

class sums : public testing::Test {
protected:
  expression of_kind(symbol_kind kind, const char* called, int position) {
    return variable(g, {kind, kanexpr::base::name(called), position});
  }
  expression coordinate(const char* called, int position) {
    return of_kind(symbol_kind::coordinate, called, position);
  }
  bool alike(const expression& a, const expression& b, const sequence<expression>& all) {
    sequence<int> nodes;
    for (const expression& e : all) nodes.push(e.node());
    return equal_units(g, nodes).have_same_unit(a.node(), b.node());
  }
  expression number(double value) { return constant(g, real(value)); }

  graph g;
  expression x = coordinate("x", 0), y = coordinate("y", 1), angle = coordinate("q", 2),
             other = coordinate("p", 3);
  expression l = of_kind(symbol_kind::parameter, "l", 0), k = of_kind(symbol_kind::parameter, "k", 1);
  expression dx = of_kind(symbol_kind::coordinate_rate, "x'", 0),
             dy = of_kind(symbol_kind::coordinate_rate, "y'", 1);
  expression u = of_kind(symbol_kind::speed, "u", 0), v = of_kind(symbol_kind::speed, "v", 1);
};

TEST_F(sums, have_terms_of_one_unit) {
  EXPECT_TRUE(alike(x, y, {x + y}));
  EXPECT_TRUE(alike(x, y, {x * x + y * y - l * l}));
  EXPECT_TRUE(alike(x, l, {x * x + y * y - l * l}));
  EXPECT_TRUE(alike(x, y, {sqrt(x * y) - l, x - l}));
  EXPECT_TRUE(alike(x, y, {x * cos(angle) + y * sin(angle)}));
  EXPECT_TRUE(alike(x, y, {x * k + l, l - abs(y) * k}));
  EXPECT_TRUE(alike(x, y, {l / x - k, k - l / y}));
  EXPECT_TRUE(alike(x, y, {atan2(x, y)}));
  EXPECT_TRUE(alike(x, y, {cbrt(x * x * y) - l, x - l}));
}

TEST_F(sums, tell_no_more_than_they_say) {
  EXPECT_FALSE(alike(x, y, {}));
  EXPECT_FALSE(alike(x, y, {x * y}));
  EXPECT_FALSE(alike(x, y, {x * k + y}));
  EXPECT_FALSE(alike(x, y, {number(1e-9) * x + y})); // the number may be 1e-9 of something
  EXPECT_FALSE(alike(x, y, {x * x + y}));
  EXPECT_FALSE(alike(x, angle, {x + l * angle, cos(angle)}));
}

TEST_F(sums, know_that_angles_have_no_unit) {
  EXPECT_TRUE(alike(angle, other, {sin(angle) + cos(other)}));
  EXPECT_TRUE(alike(angle, other, {sin(k * angle), exp(k * other)}));
  EXPECT_TRUE(alike(angle, other, {wrap_to_pi(k * angle), erf(k * other)}));
  EXPECT_TRUE(alike(x, y, {x * angle + y * sin(angle)}));
}

TEST_F(sums, know_rates) {
  EXPECT_TRUE(alike(x, y, {x * u + y * v, dx - u, dy - v}));
  EXPECT_FALSE(alike(x, y, {x * u + y * v}));
  EXPECT_TRUE(alike(x, y, {dx * k - u, dy * k - u, x, y}));
}

// The components of a quaternion, in a direction cosine.
TEST_F(sums, know_parts_of_a_quaternion) {
  const expression cosine = x * x + y * y - angle * angle - other * other;
  EXPECT_TRUE(alike(x, other, {cosine * l}));
  EXPECT_TRUE(alike(x, other, {(x * y - angle * other) * l, (x * angle + y * other) * k, x * x - y * y}));
  EXPECT_FALSE(alike(x, l, {cosine * l}));
}

} // namespace
