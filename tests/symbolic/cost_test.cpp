// builds: sanitize
#include "symbols.hpp"

#include <kanexpr/symbolic/cost.hpp>

#include <gtest/gtest.h>

namespace {

using namespace kanexpr::symbolic;

class cost_of_code : public testing::Test, protected symbols {
protected:
  cost of_all(std::initializer_list<expression> outputs) const {
    sequence<int> nodes;
    for (const expression e : outputs) nodes.push(e.node());
    return cost_of(g, nodes);
  }
};

TEST_F(cost_of_code, is_nothing_for_inputs_and_numbers) {
  EXPECT_EQ(of_all({}), cost{});
  EXPECT_EQ(of_all({a, number(3), fraction(1, 3)}), cost{});
}

TEST_F(cost_of_code, counts_by_kind) {
  EXPECT_EQ(of_all({a + b - c}), (cost{0, 2, 0, 0, 0, 2}));
  EXPECT_EQ(of_all({m * r * r / 4}), (cost{3, 0, 0, 0, 0, 3}));
  EXPECT_EQ(of_all({a / b}), (cost{0, 0, 1, 0, 0, 1}));
  EXPECT_EQ(of_all({sqrt(a) + exp(b)}), (cost{0, 1, 0, 0, 2, 3, 1}));
  EXPECT_EQ(of_all({atan2(a, b)}), (cost{0, 0, 0, 1, 0, 1}));
  EXPECT_EQ(of_all({cbrt(a) + erf(b) + wrap_to_pi(c)}), (cost{0, 2, 0, 0, 3, 5}));
  EXPECT_EQ(of_all({power(a, b)}), (cost{0, 0, 0, 0, 1, 1}));
}

TEST_F(cost_of_code, leaves_signs_free) {
  EXPECT_EQ(of_all({-a}), (cost{0, 0, 0, 0, 0, 1}));
  EXPECT_EQ(of_all({-(a * b)}), (cost{1, 0, 0, 0, 0, 2}));
}

TEST_F(cost_of_code, takes_sine_and_cosine_of_an_angle_as_one) {
  EXPECT_EQ(of_all({sin(q1), cos(q1)}), (cost{0, 0, 0, 1, 0, 2}));
  EXPECT_EQ(of_all({sin(q1), cos(q2)}), (cost{0, 0, 0, 2, 0, 2}));
  EXPECT_EQ(of_all({cos(q1)}).trigonometric, 1); // a sine that no output needs has no effect
}

TEST_F(cost_of_code, counts_what_is_shared_once_and_what_is_dead_never) {
  const expression square = a * a;
  [[maybe_unused]] const expression dead = b * c;
  EXPECT_EQ(of_all({square, square + b, square - b}), (cost{1, 2, 0, 0, 0, 3}));
  const auto live = live_nodes(g, {square.node()});
  EXPECT_EQ(live[a.node()], 1);
  EXPECT_EQ(live[dead.node()], 0);
  EXPECT_EQ(live[b.node()], 0);
}

constexpr cost compiled() {
  graph g;
  const expression p = variable(g, {symbol_kind::coordinate, "p", 0});
  const expression e = sin(p) * sin(p) - p / (p + 1);
  return cost_of(g, {e.node()});
}
static_assert(compiled() == cost{1, 2, 1, 1, 0, 5, 0, 1});

} // namespace
