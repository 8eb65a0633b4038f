// builds: no-exceptions
// Compiled and run-time systems assemble the same states.
#include "four_bars.hpp"
#include "no_heap.hpp"

#include <kanexpr/assemble.hpp>
#include <kanexpr/runtime/assemble.hpp>

#include <gtest/gtest.h>

namespace {

// Assembles a four-bar linkage from the same guess as a compiled and a run-time system; x is that of the
// compiled one.
struct assembled_both_ways {
  kanexpr::assembly compiled, derived;
  Eigen::VectorXd by_derived;

  explicit assembled_both_ways(four_bars& b) : by_derived(b.x) {
    auto model = kanexpr::derive<four_bars::System>();
    derived = kanexpr::assemble(model, by_derived, b.p, b.r);
    no_heap::guard guard;
    compiled = kanexpr::assemble<four_bars::System>(b.x, b.p, b.r);
  }
};

TEST(assemble, closes_the_loop_and_gives_the_dependent_speeds) {
  using namespace four_bar;
  four_bars b;
  const auto guess = b.x;
  const assembled_both_ways done(b);
  for (const kanexpr::assembly& a : {done.compiled, done.derived}) {
    EXPECT_TRUE(a);
    EXPECT_EQ(a.cause(), "");
    EXPECT_GT(a.steps, 1);
    EXPECT_LT(a.configuration_residual, 1e-15);
    EXPECT_LT(a.velocity_residual, 1e-15);
  }
  EXPECT_LE((b.x - done.by_derived).norm(), 1e-15);
  EXPECT_EQ(b.x[q1], guess[q1]);
  EXPECT_EQ(b.x[u1], guess[u1]);
  EXPECT_LT((b.x - guess).norm(), 3); // the branch that was guessed
  // computed by hand: the loop and its rate
  const double a = b.x[q1], c = a + b.x[q2], d = c + b.x[q3], wa = b.x[u1], wc = wa + b.x[u2],
               wd = wc + b.x[u3];
  EXPECT_NEAR(0.7 * std::cos(a) + 1.8 * std::cos(c) + 1.2 * std::cos(d), 2, 1e-15);
  EXPECT_NEAR(0.7 * std::sin(a) + 1.8 * std::sin(c) + 1.2 * std::sin(d), 0, 1e-15);
  EXPECT_NEAR(0.7 * std::sin(a) * wa + 1.8 * std::sin(c) * wc + 1.2 * std::sin(d) * wd, 0, 1e-14);
  EXPECT_NEAR(0.7 * std::cos(a) * wa + 1.8 * std::cos(c) * wc + 1.2 * std::cos(d) * wd, 0, 1e-14);
}

TEST(assemble, says_that_lengths_do_not_reach_and_leaves_the_state) {
  four_bars b;
  b.p[four_bar::l0] = 5; // the total length of the bars is 3.7
  const auto guess = b.x;
  const assembled_both_ways done(b);
  EXPECT_EQ(b.x, guess);
  EXPECT_EQ(done.by_derived, guess);
  for (const kanexpr::assembly& a : {done.compiled, done.derived}) {
    EXPECT_FALSE(a);
    EXPECT_GT(a.configuration_residual, 1);
    EXPECT_NE(a.cause().find("with a residual of "), std::string_view::npos) << a.cause();
  }
}

// Assembled, but with all bars in line.
TEST(assemble, says_that_speeds_are_singular) {
  using namespace four_bar;
  four_bars b;
  b.p[l0] = 3.5, b.p[l1] = 0.75, b.p[l2] = 1.5, b.p[l3] = 1.25;
  b.x[q1] = b.x[q2] = b.x[q3] = 0;
  b.x[u1] = 1;
  const auto guess = b.x;
  const assembled_both_ways done(b);
  for (const kanexpr::assembly& a : {done.compiled, done.derived}) {
    EXPECT_FALSE(a);
    EXPECT_EQ(a.configuration_residual, 0);
    EXPECT_EQ(a.cause(), "the constraints cannot be solved for the dependent speeds u2 and u3 at this state");
  }
  EXPECT_EQ(b.x, guess);
  EXPECT_EQ(done.by_derived, guess);
}

TEST(assemble, does_not_take_what_is_no_number) {
  four_bars b;
  b.p[four_bar::l3] = std::numeric_limits<double>::quiet_NaN();
  const auto guess = b.x;
  const assembled_both_ways done(b);
  EXPECT_FALSE(done.compiled);
  EXPECT_FALSE(done.derived);
  EXPECT_EQ(b.x, guess);
}

} // namespace
