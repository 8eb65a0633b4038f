#include <kanexpr/symbolic/derivatives/accumulate.hpp>
#include <kanexpr/symbolic/graph/live_nodes.hpp>
#include <kanexpr/symbolic/printing/print.hpp>

#include <gtest/gtest.h>

namespace {

using namespace kanexpr::symbolic;

// f = Σ c_i g_i(x·y), in a graph whose nodes are created in a different order for each `first`.
struct sum_in_a_graph {
  graph g;
  expression x, y, f;

  explicit sum_in_a_graph(int first) {
    x = variable(g, {symbol_kind::coordinate, "x", 0});
    y = variable(g, {symbol_kind::coordinate, "y", 1});
    const auto part = [&](int i) {
      const expression both = i % 2 == 0 ? x * y : y * x;
      return expression(g, g.constant(real(0.1 * i + 0.3))) * sin(both + i);
    };
    for (int i = 0; i < 6; ++i) part((i + first) % 6);
    f = part(0);
    for (int i = 1; i < 6; ++i) f += part(i);
  }

  sequence<int> order() { return reverse_topological_order(g, {f.node()}); }
};

TEST(reverse_topological_order, has_each_node_once_before_its_operands) {
  sum_in_a_graph s(2);
  const sequence<int> order = s.order();
  const auto live = live_nodes(s.g, {s.f.node()});
  int count = 0;
  for (int id = 0; id < s.g.size(); ++id) count += live[id];
  EXPECT_EQ(order.size(), count);
  for (int i = 0; i < order.size(); ++i) {
    const node& n = s.g[order[i]];
    if (is_leaf(n.op)) continue;
    EXPECT_GT(order.find(n.a), i);
    if (is_binary(n.op)) {
      EXPECT_GT(order.find(n.b), i);
    }
  }
}

// The order of a sum over the users of a node does not depend on their numbers.
TEST(reverse_topological_order, follows_from_what_nodes_are) {
  sum_in_a_graph one(0);
  for (int first = 1; first < 6; ++first) {
    sum_in_a_graph other(first);
    const sequence<int> a = one.order(), b = other.order();
    ASSERT_EQ(a.size(), b.size());
    bool same_numbers = true;
    for (int i = 0; i < a.size(); ++i) {
      EXPECT_EQ(print({one.g, a[i]}), print({other.g, b[i]}));
      same_numbers = same_numbers && a[i] == b[i];
    }
    EXPECT_FALSE(same_numbers);
  }
}

} // namespace
