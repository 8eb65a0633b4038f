// The order of the steps of straight-line code: few values are live simultaneously, and each value is
// computed before it is used.
#include <kanexpr/lower/step_order.hpp>
#include <kanexpr/symbolic.hpp>
#include <models/bicycle.hpp>
#include <models/iiwa.hpp>
#include <models/rolling_disc.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace {

using kanexpr::base::sequence;
using kanexpr::symbolic::graph;
using kanexpr::symbolic::operation;

sequence<int> in_order(const graph& g, const sequence<int>& results) {
  const sequence<int> live = kanexpr::symbolic::live_values(g, results);
  const kanexpr::base::zeros<int> no_slots(g.size());
  kanexpr::base::zeros<int> listed(live.size());
  for (int i = 0; i < live.size(); ++i) listed[i] = live[i];
  kanexpr::lower::step_order<false> steps(g, listed, live.size(), no_slots, results);
  const kanexpr::base::zeros<int>& found = steps.run();
  sequence<int> order;
  for (int i = 0; i < steps.size(); ++i) order.push(found[i]);
  return order;
}

/// The largest number of values that are live simultaneously when code runs in a given order.
int most_at_once(const graph& g, const sequence<int>& order) {
  std::vector<int> last_use(static_cast<std::size_t>(g.size()), -1);
  const auto operands = [&](int id) {
    const kanexpr::symbolic::node& n = g[id];
    std::vector<int> all{n.a};
    if (kanexpr::symbolic::is_binary(n.op)) all.push_back(n.b);
    return all;
  };
  for (int i = 0; i < order.size(); ++i)
    for (int each : operands(order[i])) last_use[static_cast<std::size_t>(each)] = i;
  int held = 0, most = 0;
  for (int i = 0; i < order.size(); ++i) {
    std::vector<int> ended = operands(order[i]);
    std::sort(ended.begin(), ended.end());
    ended.erase(std::unique(ended.begin(), ended.end()), ended.end());
    for (int each : ended)
      if (g[each].op > operation::symbol && last_use[static_cast<std::size_t>(each)] == i) --held;
    if (last_use[static_cast<std::size_t>(order[i])] >= 0) ++held;
    most = std::max(most, held);
  }
  return most;
}

int symbol(graph& g, std::string_view called, int position) {
  return g.variable({kanexpr::symbolic::symbol_kind::coordinate, kanexpr::base::name(called), position});
}

/// A random graph of sums, products and functions.
struct random_code {
  graph g{};
  sequence<int> results{};

  explicit random_code(unsigned seed) {
    std::mt19937 random(seed);
    sequence<int> all;
    for (int i = 0; i < 6; ++i) all.push(symbol(g, std::string(1, static_cast<char>('a' + i)), i));
    const auto any = [&] { return all[static_cast<int>(random() % static_cast<unsigned>(all.size()))]; };
    for (int i = 0; i < 200; ++i) {
      const operation op = std::array{operation::add, operation::subtract, operation::multiply,
                                      operation::negate, operation::sin}[random() % 5];
      all.push(g.find_or_append({op, any(), kanexpr::symbolic::is_binary(op) ? any() : 0}));
    }
    for (int i = 0; i < 5; ++i) results.push(any());
  }
};

TEST(step_order, has_each_step_once_behind_its_operands) {
  for (unsigned seed = 0; seed < 100; ++seed) {
    const random_code code(seed);
    const sequence<int> order = in_order(code.g, code.results);
    std::vector<bool> there(static_cast<std::size_t>(code.g.size()));
    const auto is_there = [&](int id) {
      return code.g[id].op <= operation::symbol || there[static_cast<std::size_t>(id)];
    };
    for (int id : order) {
      const kanexpr::symbolic::node& n = code.g[id];
      EXPECT_FALSE(is_there(id));
      EXPECT_TRUE(is_there(n.a));
      EXPECT_TRUE(!kanexpr::symbolic::is_binary(n.op) || is_there(n.b));
      there[static_cast<std::size_t>(id)] = true;
    }
    for (int id : kanexpr::symbolic::live_values(code.g, code.results)) EXPECT_TRUE(is_there(id));
    for (int id : code.results) EXPECT_TRUE(is_there(id));
  }
}

TEST(step_order, holds_fewer_values_than_the_graph) {
  const auto check = [](kanexpr::model&& m) {
    const kanexpr::symbolic::matrix udot = m.udot();
    const graph& g = udot.entries[0].owner();
    const sequence<int> results = kanexpr::symbolic::nodes_of(udot.entries);
    sequence<int> as_derived;
    for (int id : kanexpr::symbolic::live_values(g, results))
      if (g[id].op > operation::symbol) as_derived.push(id);
    EXPECT_LT(most_at_once(g, in_order(g, results)), most_at_once(g, as_derived));
  };
  check(kanexpr::derive<iiwa::System>());
  check(kanexpr::derive<bicycle::System>());
  check(kanexpr::derive<rolling_disc::System>());
}

TEST(step_order, puts_products_before_their_sum) {
  graph g;
  const int a = symbol(g, "a", 0), b = symbol(g, "b", 1), c = symbol(g, "c", 2);
  const int product = g.find_or_append({operation::multiply, a, b});
  const int sine = g.find_or_append({operation::sin, c, 0});
  const int cosine = g.find_or_append({operation::cos, sine, 0});
  const int sum = g.find_or_append({operation::add, product, cosine});
  const sequence<int> order = in_order(g, {sum});
  ASSERT_EQ(order.size(), 4);
  EXPECT_EQ(order[0], sine);
  EXPECT_EQ(order[1], cosine);
  EXPECT_EQ(order[2], product);
  EXPECT_EQ(order[3], sum);
}

TEST(step_order, looks_one_step_ahead) {
  graph g;
  const int a = symbol(g, "a", 0), b = symbol(g, "b", 1), c = symbol(g, "c", 2);
  const int first = g.find_or_append({operation::sin, a, 0});
  const int later = g.find_or_append({operation::sin, b, 0});
  const int second = g.find_or_append({operation::sin, c, 0});
  const int sum = g.find_or_append({operation::add, first, second});
  const int end = g.find_or_append({operation::add, sum, later});
  const sequence<int> order = in_order(g, {end});
  ASSERT_EQ(order.size(), 5);
  int next = 0;
  for (int id : {first, second, sum, later, end}) EXPECT_EQ(order[next++], id);
}

/// How often a processor moves values between memory and its registers if it keeps those that are needed next
/// (Belady, A study of replacement algorithms, 1966). Numbers and arguments are operands in memory.
int moves(const graph& g, const sequence<int>& order, std::size_t registers) {
  std::vector<std::vector<int>> uses(static_cast<std::size_t>(g.size())); // in reverse
  const auto operands = [&](int id) {
    std::vector<int> all;
    for (int each : {g[id].a, kanexpr::symbolic::is_binary(g[id].op) ? g[id].b : g[id].a})
      if (g[each].op > operation::symbol && std::find(all.begin(), all.end(), each) == all.end())
        all.push_back(each);
    return all;
  };
  const auto uses_of = [&](int id) -> std::vector<int>& { return uses[static_cast<std::size_t>(id)]; };
  for (int i = order.size() - 1; i >= 0; --i)
    for (int each : operands(order[i])) uses_of(each).push_back(i);
  int moved = 0;
  std::vector<int> held;
  std::vector<bool> is_stored(static_cast<std::size_t>(g.size()));
  const auto hold = [&](int id, int now) {
    if (held.size() == registers) {
      const auto furthest = std::max_element(held.begin(), held.end(), [&](int a, int b) {
        const auto next = [&](int x) { return uses_of(x).back() == now ? -1 : uses_of(x).back(); };
        return next(a) < next(b);
      });
      if (!is_stored[static_cast<std::size_t>(*furthest)]) ++moved;
      is_stored[static_cast<std::size_t>(*furthest)] = true;
      held.erase(furthest);
    }
    held.push_back(id);
  };
  for (int i = 0; i < order.size(); ++i) {
    const std::vector<int> read = operands(order[i]);
    for (int each : read)
      if (std::find(held.begin(), held.end(), each) == held.end()) {
        ++moved;
        hold(each, i);
      }
    for (int each : read) {
      uses_of(each).pop_back();
      if (uses_of(each).empty()) held.erase(std::find(held.begin(), held.end(), each));
    }
    if (!uses_of(order[i]).empty()) hold(order[i], i);
  }
  return moved;
}

TEST(step_order, moves_few_values_through_memory) {
  kanexpr::model m = kanexpr::derive<iiwa::System>();
  kanexpr::symbolic::matrix derivatives = m.get(kanexpr::mechanics::quantity::state_matrix);
  for (const auto& each : m.get(kanexpr::mechanics::quantity::input_matrix).entries)
    derivatives.entries.push(each);
  const graph& g = derivatives.entries[0].owner();
  const sequence<int> results = kanexpr::symbolic::nodes_of(derivatives.entries);
  sequence<int> as_derived;
  for (int id : kanexpr::symbolic::live_values(g, results))
    if (g[id].op > operation::symbol) as_derived.push(id);
  const auto share = [&](std::size_t registers) {
    return double(moves(g, in_order(g, results), registers)) / moves(g, as_derived, registers);
  };
  EXPECT_LT(share(16), 0.84); // 0.87 without looking ahead
  EXPECT_LT(share(32), 0.89); // 0.91
}

} // namespace
