// builds: clang++
// The results that must be checked to be sure that all are finite.
#include <kanexpr/symbolic/graph/functions.hpp>
#include <kanexpr/symbolic/sizes/finiteness.hpp>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace {

using namespace kanexpr::symbolic;

class finiteness_of : public testing::Test {
protected:
  expression coordinate(const char* called) {
    return variable(g, {symbol_kind::coordinate, kanexpr::base::name(called), next++});
  }
  // The indices among `outputs` of those to check, in any order.
  std::vector<int> watched(const std::vector<expression>& outputs, const sequence<int>& sure = {}) {
    sequence<int> nodes;
    for (const expression& e : outputs) nodes.push(e.node());
    std::vector<int> places;
    for (int id : finiteness(g, nodes, live_list(g, nodes), sure).outputs_to_check())
      for (std::size_t i = 0; i < outputs.size(); ++i)
        if (outputs[i].node() == id) places.push_back(static_cast<int>(i));
    return places;
  }
  bool may_fail(expression e) { return !watched({e}).empty(); }
  std::string suspects(expression e, const sequence<int>& known = {}) {
    const sequence<int> nodes{e.node()};
    std::string names;
    for (int id : finiteness(g, nodes, live_list(g, nodes), {}).suspicious_symbols(known))
      names += g.symbol_at(id).called.view();
    return names;
  }

  graph g;
  int next = 0;
  expression x = coordinate("x"), y = coordinate("y"), z = coordinate("z");
};

using places = std::vector<int>;

TEST_F(finiteness_of, sums_products_and_most_functions_is_not_watched) {
  for (const expression& e :
       {x, x * y + z, sin(x) * cos(y), tan(x), atan(x), atan2(x, y), abs(x), sign(x), cbrt(x), erf(x),
        wrap_to_pi(x), x / 3, sqrt(x * x + 2 * (y * y)), sqrt(x * x) * sqrt(abs(y))})
    EXPECT_FALSE(may_fail(e));
  for (const expression& e : {x / y, 1 / x, sqrt(x), sqrt(x * x - y), sqrt(x * y), log(x), exp(x), asin(x),
                              acos(x), power(x, y), x + sin(y / z)})
    EXPECT_TRUE(may_fail(e));
}

TEST_F(finiteness_of, numbers_fails_if_a_reciprocal_overflows) {
  EXPECT_FALSE(may_fail(x / 1e-300));
  EXPECT_FALSE(may_fail(sin(x) * 1e-309));
  EXPECT_TRUE(may_fail(x / 1e-309));
  EXPECT_TRUE(may_fail(y + z * sin(x / 1e-309)));
}

TEST_F(finiteness_of, outputs_is_told_by_what_is_made_of_them) {
  const expression q = x / y;
  EXPECT_EQ(watched({q, z * q + 1, z}), (places{1}));
  EXPECT_EQ(watched({q, -q, sin(q)}), (places{2, 1}));     // neither of the last two contains the other
  EXPECT_EQ(watched({q, 1 / q, atan(q)}).size(), 3u);      // 1/∞ hides it
  EXPECT_EQ(watched({q, z / x}, {y.node()}), (places{1})); // y is known not to vanish
  EXPECT_EQ(watched({q, z / x}, {x.node(), y.node()}).size(), 0u);
}

TEST_F(finiteness_of, a_sum_lets_nothing_cancel) {
  const expression q = x / y;
  const int sum = unsimplified_sum(g, {q.node(), (-q).node(), z.node()});
  EXPECT_EQ(g[sum].op, operation::add);
  EXPECT_EQ(live_nodes(g, {sum})[q.node()], 1);
}

TEST_F(finiteness_of, suspects_is_what_it_rests_on) {
  EXPECT_EQ(suspects(z * x / y), "y");
  EXPECT_EQ(suspects(z * log(x + y) + z / 2), "xy");
  EXPECT_EQ(suspects(z / (x * y) + 1 / z, {z.node()}), "xy");
  EXPECT_EQ(suspects(x + y), "");
}

TEST_F(finiteness_of, angles_only_is_bounded) {
  const auto bounded = [&](expression e) { return depend_only_on_angles(g, {e.node()}); };
  EXPECT_TRUE(bounded(sin(x) * cos(y * y) + 2));
  EXPECT_FALSE(bounded(sin(x) + x));
  EXPECT_FALSE(bounded(tan(x)));
}

} // namespace
