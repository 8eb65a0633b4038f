// builds: g++ no-exceptions
// Fixed steps through positions in which constraints are linearly dependent.
#include "no_heap.hpp"
#include "steps/double_four_bar.hpp"

#include <kanexpr/fixed_step.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

using namespace double_four_bar;

// A bead on the curve x = y³, upwards through y = 0: the pivot 3 y² of vy touches zero and keeps its sign.
namespace bead {

using namespace kanexpr;

constexpr coordinate<"x"> x;
constexpr coordinate<"y"> y;
constexpr speed<"vx"> vx;
constexpr speed<"vy"> vy;

struct N : inertial_frame<N> {};
struct O : origin<O, N> {};
struct P : offset<P, O, x * N::x + y * N::y> {};
struct Bead : particle<Bead, P, 1> {};
struct System
    : kane_system<inertial<N>, coordinates<x, y>, speeds<vx, vy>, kinematics<dot(x) == vx, dot(y) == vy>,
                  bodies<Bead>, configuration_constraints<x == y * y * y>, dependent<y, vy>,
                  loads<gravity<-9.81 * N::y>>> {};

double energy(const state<System>& at) { return (at[vx] * at[vx] + at[vy] * at[vy]) / 2 + 9.81 * at[y]; }

/// The state at this height, moving up.
state<System> rising(double height, double to_the_right) {
  const double slope = 3 * height * height;
  return {{x, height * height * height}, {y, height}, {vx, to_the_right}, {vy, to_the_right / slope}};
}

} // namespace bead

TEST(fixed_step, refuses_to_touch_a_singular_position) {
  for (const double h : {1e-2, 1e-3, 1e-4})
    for (int i = 0; i < 40; ++i) { // zero is touched anywhere within a step
      auto x = bead::rising(-0.3 - 0.001 * i, 1);
      const double first = bead::energy(x);
      double t = 0, kept = first;
      status s;
      while (s && t < 0.5) kept = bead::energy(x), s = runge_kutta_4<bead::System>{}(t, x, h);
      EXPECT_EQ(s.cause(), steps::singular_position) << h << ' ' << i;
      EXPECT_LT(x[bead::y], 0);
      EXPECT_NEAR(kept / first, 1, 1e-3);
    }
}

template <class Step>
void expect_a_pass(double loss) {
  auto x = bead::rising(-0.3, 1);
  const double first = bead::energy(x);
  double t = 0;
  bool good = true;
  for (int i = 0; i < 500; ++i) good = good && passing<Step>{}(t, x, 1e-3);
  EXPECT_TRUE(good);
  EXPECT_GT(x[bead::y], 0.1);
  EXPECT_NEAR(bead::energy(x) / first, 1, loss);
}

TEST(fixed_step, passes_what_it_would_touch) {
  expect_a_pass<runge_kutta_4<bead::System>>(1e-8);
  expect_a_pass<ralston_3<bead::System>>(1e-5);
}

TEST(fixed_step, refuses_to_pass_a_singular_position) {
  for (const double h : {1e-3, 1e-4}) {
    auto x = upright();
    double t = 0;
    status s;
    while (s && t < 10) s = runge_kutta_4<System>{}(t, x, h);
    EXPECT_EQ(
        s.cause(),
        "the step passes through or comes close to a position where the constraints cannot be solved for "
        "the dependent speeds: use passing<...>, or a different dependent<...> if only this choice is "
        "singular");
    EXPECT_NEAR(t, 0.7143, 1e-3);
    EXPECT_NEAR(x[q1], 0, 1e-2);
    EXPECT_NEAR(energy(x[q1], x[u1]), energy(upright()[q1], -1), 1e-6);
  }
}

TEST(fixed_step, passes_singular_positions_and_leaves_the_energy) {
  for (const double h : {1e-3, 1e-4}) {
    auto x = upright();
    const double first = energy(x[q1], x[u1]);
    double t = 0, worst = 0;
    const passing<runge_kutta_4<System>> step;
    bool good = true;
    {
      const no_heap::guard guard;
      for (int i = 0; i < static_cast<int>(10 / h); ++i) {
        good = good && step(t, x, h);
        worst = (std::max)(worst, std::abs(energy(x[q1], x[u1]) - first));
      }
    }
    EXPECT_TRUE(good);
    EXPECT_LT(worst, 1e-6);
    EXPECT_LT(x[q1], -9 * std::numbers::pi);
    EXPECT_NEAR(x[q2], x[q1], 1e-9); // on the branch of equal cranks
    EXPECT_NEAR(x[q3], x[q1], 1e-9);
  }
}

// The number of full turns of an angle does not matter.
TEST(fixed_step, passes_after_many_turns_as_at_first) {
  for (const int turns : {0, 5, 10, 50}) {
    auto x = upright();
    x[q1] = x[q2] = x[q3] = 2 * std::numbers::pi * turns + 0.3;
    x[u1] = x[u2] = x[u3] = -20;
    const double first = energy(x[q1], x[u1]);
    double t = 0;
    bool good = true;
    for (int i = 0; i < 30; ++i) good = good && passing<runge_kutta_4<System>>{}(t, x, 1e-3);
    EXPECT_TRUE(good);
    EXPECT_LT(x[q1], 2 * std::numbers::pi * turns - 0.25);
    EXPECT_NEAR(energy(x[q1], x[u1]) / first, 1, 1e-11) << turns;
  }
}

TEST(fixed_step, passes_by_floats_and_by_euler) {
  auto x = upright<float>();
  float now = 0;
  bool good = true;
  for (int i = 0; i < 2000; ++i) good = good && passing<runge_kutta_4<System>>{}(now, x, 1e-3f);
  EXPECT_TRUE(good);
  auto y = upright();
  double t = 0;
  for (int i = 0; i < 20000; ++i) good = good && passing<semi_implicit_euler<System>>{}(t, y, 1e-4);
  EXPECT_TRUE(good);
  EXPECT_NEAR(x[q1], y[q1], 2e-2);
}

// Far from such positions, `passing` gives the same bits as the step.
TEST(fixed_step, passes_nothing_where_nothing_is_to_pass) {
  auto x = upright(), y = x;
  double t = 0;
  for (int i = 0; i < 300; ++i) {
    double same = t;
    EXPECT_TRUE(runge_kutta_4<System>{}(same, y, 1e-3));
    EXPECT_TRUE(passing<runge_kutta_4<System>>{}(t, x, 1e-3));
    EXPECT_EQ(x, y);
  }
}

} // namespace
