// builds: clang++ sanitize all
// Fixed steps and assembly keep quaternions at norm 1.
#include "no_heap.hpp"
#include "quaternions.hpp"

#include <kanexpr/assemble.hpp>
#include <kanexpr/fixed_step.hpp>
#include <kanexpr/runtime/assemble.hpp>
#include <models/pivot_body.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

namespace body {

using namespace pivot_body;

state<System> start() {
  state<System> x;
  x[e0] = 1;
  x[u1] = 3, x[u2] = 1, x[u3] = -2;
  return x;
}

parameter_values<System> parameters() {
  parameter_values<System> p;
  p[m] = p[Ixx] = 1, p[Iyy] = 2, p[Izz] = 2.5, p[Ixy] = 0.1, p[g] = 9.81;
  p[a] = 0.1, p[b] = 0.2, p[c] = 0.3;
  return p;
}

} // namespace body

using namespace quaternions;
using kanexpr::status;

template <class System>
double off_one(const state<System>& x) {
  return steps::unit_quaternions<System>::residual(x).cwiseAbs().maxCoeff();
}

state<Two> tumbling() {
  state<Two> x;
  x[e0] = x[f0] = 1;
  x[u1] = 2, x[v2] = 3;
  return x;
}

// The largest deviation of the norms from 1 over many steps.
template <class System, class Step>
double most_off_one(Step step, state<System> x, int steps, const parameter_values<System>& p = {},
                    const input_values<System>& r = {}) {
  double t = 0, most = 0;
  for (int i = 0; i < steps; ++i) {
    const status s = step(t, x, 1e-3, p, r);
    EXPECT_TRUE(s) << s.cause() << " at " << t;
    if (!s) break;
    most = std::max(most, off_one<System>(x));
  }
  return most;
}

template <class Step>
double most_off_one_of_a_body(Step step, int steps) {
  return most_off_one<body::System>(step, body::start(), steps, body::parameters(),
                                    input_values<body::System>(0, 0, 0));
}

TEST(fixed_step, keeps_the_norms_of_quaternions_for_100_seconds) {
  EXPECT_LT(most_off_one_of_a_body(runge_kutta_4<pivot_body::System>{}, 100'000), 1e-15);
  EXPECT_LT(most_off_one_of_a_body(semi_implicit_euler<pivot_body::System>{}, 100'000), 1e-15);
  EXPECT_GT(most_off_one_of_a_body(semi_implicit_euler<pivot_body::System, 0>{}, 1000), 1e-4);
  EXPECT_LT(most_off_one<Two>(runge_kutta_4<Two>{}, tumbling(), 20'000), 1e-15);
  EXPECT_LT(most_off_one<Two>(semi_implicit_euler<Two>{}, tumbling(), 20'000), 1e-15);
}

struct sliding {
  parameter_values<Sliding> p;
  state<Sliding> x;
  sliding() {
    p[h] = 0.2;
    x[e0] = 2, x[e1] = 0.2, x[e3] = 0.6;
    x[u1] = 0.2, x[u3] = 0.3;
  }
};

// With `passing`, because e0 crosses zero, where the constraint cannot be solved for it.
TEST(fixed_step, keeps_a_norm_and_a_constraint_that_is_solved_for_an_entry) {
  sliding s;
  ASSERT_TRUE(assemble<Sliding>(s.x, s.p));
  double t = 0, off = 0;
  for (int i = 0; i < 3000; ++i) {
    const status stepped = passing<runge_kutta_4<Sliding>>{}(t, s.x, 1e-3, s.p);
    ASSERT_TRUE(stepped) << stepped.cause() << " at " << t;
    const consistency c = check_consistency<Sliding>(s.x, s.p, {}, t, 1e-13);
    ASSERT_TRUE(c) << c.cause() << " at " << t;
    off = std::max(off, off_one<Sliding>(s.x));
  }
  EXPECT_LT(off, 1e-15);
  EXPECT_GT(std::abs(s.x[e1]), 0.01); // it moves
}

TEST(fixed_step, tells_of_a_norm_far_from_one) {
  state<Two> x = tumbling();
  x[f2] = 3;
  const state<Two> before = x;
  double t = 5;
  for (const status& s : {runge_kutta_4<Two>{}(t, x, 1e-3), semi_implicit_euler<Two>{}(t, x, 1e-3)}) {
    EXPECT_FALSE(s);
    EXPECT_EQ(s.cause(), "the norm of the quaternion f0, f1, f2 and f3 is far from 1");
  }
  EXPECT_EQ(x, before);
  EXPECT_EQ(t, 5);
}

TEST(fixed_step, takes_no_memory_with_quaternions) {
  state<Two> x = tumbling();
  sliding s;
  ASSERT_TRUE(assemble<Sliding>(s.x, s.p));
  double t = 0;
  bool good = true;
  {
    no_heap::guard guard;
    good = good && runge_kutta_4<Two>{}(t, x, 1e-3) && semi_implicit_euler<Two>{}(t, x, 1e-3);
    good = good && semi_implicit_euler<Sliding>{}(t, s.x, 1e-3, s.p);
  }
  EXPECT_TRUE(good);
}

TEST(assemble, gives_quaternions_norm_one) {
  sliding compiled, derived;
  auto model = derive<Sliding>();
  Eigen::VectorXd x = derived.x;
  for (const assembly& a : {assemble<Sliding>(compiled.x, compiled.p), assemble(model, x, derived.p)}) {
    EXPECT_TRUE(a) << a.cause();
    EXPECT_LT(a.configuration_residual, 1e-15);
    EXPECT_LT(a.velocity_residual, 1e-15);
  }
  EXPECT_LE((compiled.x - x).norm(), 1e-14);
  EXPECT_LT(off_one<Sliding>(compiled.x), 1e-15);
  EXPECT_TRUE(check_consistency<Sliding>(compiled.x, compiled.p));
  EXPECT_NEAR(compiled.x[e1] / compiled.x[e0], 0.1, 1e-15); // the given direction remains
  const auto& y = compiled.x;
  EXPECT_NEAR(0.5 * 2 * (y[e1] * y[e3] - y[e0] * y[e2]), 0.2, 1e-15); // the height, by hand
  state<Two> far = tumbling();
  far[e0] = 7;
  EXPECT_TRUE(assemble<Two>(far));
  EXPECT_EQ(far, tumbling());
}

TEST(assemble, tells_of_a_quaternion_that_is_zero) {
  state<Two> x;
  x[e0] = 1;
  auto model = derive<Two>();
  Eigen::VectorXd y = x;
  const state<Two> before = x;
  for (const assembly& a : {assemble<Two>(x), assemble(model, y)}) {
    EXPECT_FALSE(a);
    EXPECT_EQ(a.cause(), "the norm of the quaternion f0, f1, f2 and f3 is far from 1");
  }
  EXPECT_EQ(x, before);
}

TEST(check_consistency, tells_of_a_norm) {
  state<Two> x = tumbling();
  EXPECT_TRUE(check_consistency<Two>(x));
  x[f2] = 0.1;
  auto model = derive<Two>();
  const Eigen::VectorXd y = x;
  EXPECT_EQ(check_consistency<Two>(x).cause(), "the norm of the quaternion f0, f1, f2 and f3 is 1.004987562");
  EXPECT_EQ(check_consistency(model, y, Eigen::VectorXd(), Eigen::VectorXd()).cause(),
            "the norm of the quaternion f0, f1, f2 and f3 is 1.004987562");
}

// Per quaternion: squares and their sum, a root, a division, four products.
static_assert(steps::unit_quaternions<Two>::cost() ==
              symbolic::cost{.multiplications = 16, .additions = 6, .divisions = 2, .other = 2});
static_assert(semi_implicit_euler<Two>::cost().divisions ==
              semi_implicit_euler<Two, 0>::cost().divisions + 2);

} // namespace
