// builds: clang++ sanitize no-exceptions
#include "no_heap.hpp"

#include <kanexpr/batch.hpp>
#include <kanexpr/kanexpr.hpp>
#include <models/four_bar.hpp>
#include <models/simple_pendulum.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <thread>

namespace {

using namespace kanexpr;
using namespace simple_pendulum;
using eom = equations_of_motion<System>;

template <class Number>
many<state<System, Number>> pendulums(Eigen::Index systems) {
  many<state<System, Number>> x(systems);
  for (Eigen::Index i = 0; i < systems; ++i)
    x.set(i, {static_cast<Number>(0.13 * static_cast<double>(i) - 0.7),
              static_cast<Number>(1.5 - 0.2 * static_cast<double>(i))});
  return x;
}

const eom::parameters some{{m, 1.2}, {l, 0.8}, {g, 9.81}, {c, 0.1}};

template <class Step, class Number>
void expect_the_bits_of_single_steps() {
  for (Eigen::Index systems = 0; systems <= 9; ++systems) {
    const many<state<System, Number>> start = pendulums<Number>(systems);
    many<state<System, Number>> x = start;
    many<input_values<System, Number>> r(systems);
    for (Eigen::Index i = 0; i < systems; ++i) r[T](i) = static_cast<Number>(i) / 4;
    const auto p = some.cast<Number>().eval();
    rollout<Step, Number> ahead(systems, {.step = 1e-3, .steps = 50, .store_every = 20, .start = 0.5});
    {
      no_heap::guard guard;
      EXPECT_TRUE(ahead.run(x, p, r));
    }
    ASSERT_EQ(ahead.stored(), 2);
    for (Eigen::Index i = 0; i < systems; ++i) {
      double t = 0.5;
      state<System, Number> own = start.get(i);
      for (int made = 1; made <= 50; ++made) {
        ASSERT_TRUE(Step{}(t, own, 1e-3, p, r.get(i)));
        if (made % 20 != 0) continue;
        EXPECT_EQ(ahead.stored(made / 20 - 1).get(i), own);
        EXPECT_EQ(ahead.time(made / 20 - 1), t);
      }
      EXPECT_EQ(x.get(i), own);
      EXPECT_EQ(ahead.steps_of(i), 50);
      EXPECT_TRUE(ahead.status_of(i));
    }
  }
}

TEST(rollout, has_the_bits_of_single_steps) {
  expect_the_bits_of_single_steps<runge_kutta_4<System>, double>();
  expect_the_bits_of_single_steps<runge_kutta_4<System>, float>();
  expect_the_bits_of_single_steps<semi_implicit_euler<System>, double>();
}

TEST(rollout, takes_inputs_from_a_function) {
  const auto of_any = [](double t, const auto& x) {
    using number = typename std::remove_cvref_t<decltype(x)>::Scalar;
    return input_values<System, number>(lower::scalar_math<number>::from(t) - 2 * x[u]);
  };
  const auto of_one = [](double t, const eom::state& x) { return eom::inputs(t - 2 * x[u]); };
  many<eom::state> together = pendulums<double>(6), one_by_one = together;
  rollout<runge_kutta_4<System>> ahead(6, {.step = 1e-2, .steps = 30});
  EXPECT_TRUE(ahead.run(together, some, of_any));
  EXPECT_TRUE(ahead.run(one_by_one, some, of_one));
  const many<eom::state> start = pendulums<double>(6);
  for (int i = 0; i < 6; ++i) {
    double t = 0;
    eom::state own = start.get(i);
    for (int made = 0; made < 30; ++made) ASSERT_TRUE(runge_kutta_4<System>{}(t, own, 1e-2, some, of_one));
    EXPECT_EQ(together.get(i), own);
    EXPECT_EQ(one_by_one.get(i), own);
  }
}

// A motor with infinite torque beyond an angle: the systems that exceed the angle fail one after another.
TEST(rollout, leaves_systems_that_fail_and_goes_on_with_the_others) {
  const auto law = [](double, const eom::state& x) {
    return eom::inputs(x[q] > 0.3 ? std::numeric_limits<double>::infinity() : 0.2);
  };
  many<eom::state> x = pendulums<double>(11);
  const many<eom::state> start = x;
  rollout<runge_kutta_4<System>> ahead(11, {.step = 1e-2, .steps = 60, .store_every = 15});
  const status first = ahead.run(x, some, law);
  EXPECT_FALSE(first);
  Eigen::Index failures = 0;
  for (int i = 0; i < 11; ++i) {
    double t = 0;
    eom::state own = start.get(i);
    int made = 0;
    status s;
    for (; made < 60; ++made)
      if (s = runge_kutta_4<System>{}(t, own, 1e-2, some, law); !s) break;
    failures += !s;
    EXPECT_EQ(x.get(i), own) << i;
    EXPECT_EQ(ahead.steps_of(i), made);
    EXPECT_EQ(ahead.status_of(i).cause(), s.cause());
    for (int k = 0; k < 4; ++k) EXPECT_EQ(std::isnan(ahead.stored(k)[q](i)), made < 15 * (k + 1)) << i;
  }
  EXPECT_EQ(ahead.failures(), failures);
  EXPECT_GT(failures, 1);
  EXPECT_LT(failures, 10);

  x = start;
  EXPECT_TRUE(ahead.run(x, some, eom::inputs(0.2)));
  EXPECT_EQ(ahead.failures(), 0);
}

TEST(rollout, of_parameters_that_fail_at_once) {
  many<eom::state> x = pendulums<double>(5);
  const many<eom::state> start = x;
  many<eom::parameters> p(5, some);
  p[m](3) = 0;
  rollout<runge_kutta_4<System>> ahead(5, {.step = 1e-2, .steps = 10, .store_every = 10});
  EXPECT_EQ(ahead.run(x, p, eom::inputs(0.2)).cause(),
            "the mass matrix is singular at this state: its elimination fails at the speed u");
  EXPECT_EQ(ahead.failures(), 1);
  EXPECT_EQ(x.get(3), start.get(3));
  EXPECT_EQ(ahead.steps_of(3), 0);
  EXPECT_TRUE(std::isnan(ahead.stored(0)[q](3)));
  EXPECT_EQ(ahead.stored(0).get(4), x.get(4));
}

TEST(rollout, does_not_depend_on_threads) {
  const auto two = [](int chunks, const auto& chunk) {
    std::jthread other([&] {
      for (int i = 1; i < chunks; i += 2) chunk(i);
    });
    for (int i = 0; i < chunks; i += 2) chunk(i);
  };
  many<eom::state> alone = pendulums<double>(500), shared = alone;
  rollout<runge_kutta_4<System>> ahead(500, {.step = 1e-2, .steps = 20});
  EXPECT_TRUE(ahead.run(alone, some, eom::inputs(0.2)));
  EXPECT_TRUE(ahead.run(two, shared, some, eom::inputs(0.2)));
  for (int i = 0; i < 2; ++i)
    EXPECT_EQ(std::memcmp(alone(i).data(), shared(i).data(), 500 * sizeof(double)), 0);
}

TEST(rollout, refuses_what_does_not_fit) {
  many<eom::state> x = pendulums<double>(4);
  rollout<runge_kutta_4<System>> ahead(5, {.step = 1e-2, .steps = 20});
  EXPECT_EQ(ahead.run(x, some, eom::inputs(0.2)).cause(),
            "the arguments and the rollout have different numbers of systems");
  EXPECT_EQ(ahead.failures(), 5);
  rollout<runge_kutta_4<System>> backward(4, {.step = 1e-2, .steps = -1});
  EXPECT_EQ(backward.run(x, some, eom::inputs(0.2)).cause(), "the number of steps is negative");
}

} // namespace
