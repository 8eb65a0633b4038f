// builds: clang++
// An executor may omit chunks, run them again, and throw.
#include <kanexpr/batch.hpp>
#include <kanexpr/fixed_step.hpp>
#include <kanexpr/kanexpr.hpp>
#include <models/simple_pendulum.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace {

using namespace kanexpr;
using namespace simple_pendulum;
using eom = equations_of_motion<System>;

constexpr const char* left_out = "the chunk that contains this system was not run to completion";

many<eom::state> swinging(Eigen::Index systems) {
  many<eom::state> x(systems);
  for (Eigen::Index i = 0; i < systems; ++i) x[u](i) = 1 + 0.001 * static_cast<double>(i);
  return x;
}
eom::parameters plain() { return eom::parameters::Ones(); }

TEST(careless_executors, throw_and_leave_every_status_true) {
  const Eigen::Index systems = 2000;
  const many<eom::state> x = swinging(systems);
  many<eom::parameters> p(systems, plain());
  p[m](3) = 0;
  const eom::inputs r = eom::inputs::Zero();
  many_results udot(eom::udot, systems);
  const auto late = [](int chunks, const auto& chunk) {
    for (int i = 0; i + 1 < chunks; ++i) chunk(i);
    throw std::runtime_error("no more threads");
  };
  EXPECT_THROW((void)udot.evaluate(late, x, p, r), std::runtime_error);
  EXPECT_EQ(udot.status_of(3).cause(), eom::udot(x.get(3), p.get(3), r).status.cause());
  EXPECT_TRUE(udot.status_of(4));
  EXPECT_EQ(udot.status_of(systems - 1).cause(), left_out);
  EXPECT_TRUE(std::isnan(udot(0)(systems - 1)));
  EXPECT_GT(udot.failures(), 1);
  p[m] = 1;
  EXPECT_TRUE(udot.evaluate(x, p, r));
  EXPECT_EQ(udot.failures(), 0);
  EXPECT_TRUE(udot.status_of(3));
}

TEST(careless_executors, run_chunks_again) {
  many<eom::state> once = swinging(50), twice = once;
  rollout<runge_kutta_4<System>> ahead(50, {.step = 0.1, .steps = 10});
  EXPECT_TRUE(ahead.run(once, plain(), eom::inputs::Zero()));
  const auto again = [](int chunks, const auto& chunk) {
    for (int i = 0; i < 2 * chunks; ++i) chunk(i / 2);
  };
  EXPECT_TRUE(ahead.run(again, twice, plain(), eom::inputs::Zero()));
  for (int i = 0; i < 50; ++i) EXPECT_EQ(once.get(i), twice.get(i));
}

TEST(careless_executors, meet_inputs_that_throw) {
  many<eom::state> x = swinging(3);
  rollout<runge_kutta_4<System>> ahead(3, {.step = 0.1, .steps = 10, .store_every = 5});
  int calls = 0;
  const auto law = [&](double, const eom::state&) -> eom::inputs {
    if (++calls > 20) throw std::runtime_error("no input");
    return eom::inputs::Zero();
  };
  EXPECT_THROW((void)ahead.run(x, plain(), law), std::runtime_error);
  EXPECT_EQ(ahead.failures(), 3);
  EXPECT_EQ(ahead.status_of(0).cause(), left_out);
  EXPECT_EQ(ahead.steps_of(0), 0);
  EXPECT_TRUE(std::isnan(ahead.stored(1)[q](0)));
}

// Two chunks that shared a batch would both advance it.
TEST(careless_executors, are_given_whole_batches) {
  for (const int systems : {1, 500, 19584, 100001})
    for (const int width : {1, 4, 16, 32, 128}) {
      const batches::chunks parts = batches::chunks::of(systems, 2 * width, width);
      EXPECT_EQ(parts.length % width, 0);
      EXPECT_GE(parts.count * parts.length, systems);
      EXPECT_LE(parts.count, batches::chunks::most);
    }
}

} // namespace
