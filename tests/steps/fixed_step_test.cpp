// builds: sanitize
#include "no_heap.hpp"

#include <kanexpr/fixed_step.hpp>
#include <kanexpr/lower/pack.hpp>
#include <models/rotating_tube.hpp>
#include <models/simple_pendulum.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

// A bead on a rod that rotates uniformly in the plane, pushed along x: s̈ = w² s + F cos(w t)/m.
namespace bead {

using namespace kanexpr;

constexpr coordinate<"s"> s;
constexpr speed<"v"> v;
constexpr parameter<"m"> m;
constexpr parameter<"w"> w;
constexpr parameter<"F"> F;
constexpr time_variable t;

struct N : inertial_frame<N> {};
struct Rod : rotated<Rod, N, w * t, N::z> {};
struct O : origin<O, N> {};
struct P : offset<P, O, s * Rod::x> {};
struct Bead : particle<Bead, P, m> {};
struct System : kane_system<inertial<N>, coordinates<s>, speeds<v>, kinematics<dot(s) == v>,
                            parameters<m, w, F>, bodies<Bead>, loads<force<P, F * N::x>>> {};

} // namespace bead

namespace {

using kanexpr::ralston_3;
using kanexpr::runge_kutta_4;
using kanexpr::semi_implicit_euler;
using kanexpr::status;

// The observed order: log2 of the ratio of the errors before and after halving the step.
template <class Error>
double order_of(Error error_with, int steps) {
  return std::log2(error_with(steps) / error_with(2 * steps));
}

using pendulum = kanexpr::equations_of_motion<simple_pendulum::System>;

pendulum::parameters conservative() {
  using namespace simple_pendulum;
  pendulum::parameters p;
  p[m] = 1.3, p[l] = 0.7, p[g] = 9.81, p[c] = 0;
  return p;
}

// A pendulum released at rest hangs straight down after a quarter of its period, an elliptic integral.
template <class System, class Step>
double error_of_pendulum(Step step, int steps) {
  using namespace simple_pendulum;
  using eom = kanexpr::equations_of_motion<System>;
  const pendulum::parameters p = conservative();
  const double start = 1.9, frequency = std::sqrt(p[g] / p[l]);
  const double quarter = std::comp_ellint_1(std::sin(start / 2)) / frequency;
  double now = 0;
  typename eom::state x(start, 0);
  for (int i = 0; i < steps; ++i)
    EXPECT_TRUE(step(now, x, quarter / steps, typename eom::parameters(p), typename eom::inputs(0.0)));
  EXPECT_NEAR(now, quarter, 1e-12);
  return (x - typename eom::state(0, -2 * frequency * std::sin(start / 2))).norm();
}

TEST(fixed_step, has_its_order_for_a_pendulum) {
  using simple_pendulum::LagrangeSystem;
  using simple_pendulum::System;
  const auto euler = [](int n) { return error_of_pendulum<System>(semi_implicit_euler<System>{}, n); };
  const auto ralston = [](int n) { return error_of_pendulum<System>(ralston_3<System>{}, n); };
  const auto runge_kutta = [](int n) { return error_of_pendulum<System>(runge_kutta_4<System>{}, n); };
  EXPECT_NEAR(order_of(euler, 2000), 1, 0.02);
  EXPECT_NEAR(order_of(ralston, 200), 3, 0.1);
  EXPECT_NEAR(order_of(runge_kutta, 100), 4, 0.1);
  EXPECT_LT(runge_kutta(1000), 1e-11);
  EXPECT_LT(error_of_pendulum<LagrangeSystem>(runge_kutta_4<LagrangeSystem>{}, 1000), 1e-11);
}

template <class Step>
double error_of_bead(Step step, int steps) {
  using eom = kanexpr::equations_of_motion<bead::System>;
  const double m = 0.6, w = 1.7, force = 2.3, end = 1.2, start = 0.4;
  const double part = -force / (2 * m * w * w); // the particular solution is part · cos(w t)
  double now = 0;
  eom::state x(start + part, 0);
  for (int i = 0; i < steps; ++i) EXPECT_TRUE(step(now, x, end / steps, eom::parameters(m, w, force)));
  const eom::state exact(start * std::cosh(w * end) + part * std::cos(w * end),
                         start * w * std::sinh(w * end) - part * w * std::sin(w * end));
  return (x - exact).norm();
}

TEST(fixed_step, has_its_order_where_the_equations_hold_the_time) {
  const auto euler = [](int n) { return error_of_bead(semi_implicit_euler<bead::System>{}, n); };
  const auto ralston = [](int n) { return error_of_bead(ralston_3<bead::System>{}, n); };
  const auto runge_kutta = [](int n) { return error_of_bead(runge_kutta_4<bead::System>{}, n); };
  EXPECT_NEAR(order_of(euler, 1000), 1, 0.02);
  EXPECT_NEAR(order_of(ralston, 80), 3, 0.1);
  EXPECT_NEAR(order_of(runge_kutta, 40), 4, 0.1);
}

// A smooth tube that rotates uniformly, without a spring: q̈ = w² q − g sin(w t).
template <class Step>
double error_of_tube(Step step, int steps) {
  using namespace rotating_tube;
  using eom = kanexpr::equations_of_motion<System>;
  const double rate = 1.7, end = 1.2, start = 0.4;
  const eom::parameters p{{m, 0.9}, {g, 9.81}, {k, 0}, {q0, 0}, {c, 0}};
  const double part = p[g] / (2 * rate * rate);
  const auto turning = [&](double t, const eom::state&) {
    return eom::inputs{{theta, rate * t}, {dot(theta), rate}, {dot(dot(theta)), 0}};
  };
  double now = 0;
  eom::state x(start, part * rate);
  for (int i = 0; i < steps; ++i) EXPECT_TRUE(step(now, x, end / steps, p, turning));
  const eom::state exact(start * std::cosh(rate * end) + part * std::sin(rate * end),
                         start * rate * std::sinh(rate * end) + part * rate * std::cos(rate * end));
  return (x - exact).norm();
}

TEST(fixed_step, has_its_order_with_prescribed_motion) {
  const auto euler = [](int n) { return error_of_tube(semi_implicit_euler<rotating_tube::System>{}, n); };
  const auto runge_kutta = [](int n) { return error_of_tube(runge_kutta_4<rotating_tube::System>{}, n); };
  EXPECT_NEAR(order_of(euler, 1000), 1, 0.02);
  EXPECT_NEAR(order_of(runge_kutta, 40), 4, 0.1);
}

// The explicit Euler method, which advances the coordinates with the old speeds.
struct explicit_euler {
  status operator()(double& t, pendulum::state& x, double h, const pendulum::parameters& p,
                    const pendulum::inputs& r) const {
    x += h * pendulum::rhs(t, x, p, r);
    t += h;
    return {};
  }
};

template <class Step>
double largest_change_of_energy(Step step, int steps) {
  const pendulum::parameters p = conservative();
  const auto energy = [&](const pendulum::state& x) {
    return pendulum::kinetic_energy(x, p) + pendulum::potential_energy(x, p);
  };
  pendulum::state x(1.1, 0.3);
  const double start = energy(x);
  double now = 0, largest = 0;
  for (int i = 0; i < steps; ++i) {
    EXPECT_TRUE(step(now, x, 0.01, p, pendulum::inputs(0.0)));
    largest = std::max(largest, std::abs(energy(x) - start));
  }
  return largest;
}

TEST(semi_implicit_euler, keeps_the_energy_bounded) {
  const semi_implicit_euler<simple_pendulum::System> step;
  const double early = largest_change_of_energy(step, 1000), late = largest_change_of_energy(step, 100000);
  EXPECT_LT(late, 0.25); // of 4.9 J above the minimum
  EXPECT_LT(late, 1.05 * early);
  EXPECT_GT(largest_change_of_energy(explicit_euler(), 1000), 5);
}

// u ← u + h u̇, then q ← q + h u, by hand.
TEST(semi_implicit_euler, takes_the_new_speeds) {
  using namespace simple_pendulum;
  pendulum::parameters p = conservative();
  p[c] = 0.4;
  const double start = 0.8, speed = -1.6, h = 0.03, torque = 0.9;
  const double after =
      speed + h * ((torque - p[c] * speed) / (p[m] * p[l] * p[l]) - p[g] / p[l] * std::sin(start));
  double now = 2;
  pendulum::state x(start, speed);
  EXPECT_TRUE(semi_implicit_euler<System>{}(now, x, h, p, pendulum::inputs(torque)));
  EXPECT_NEAR(x[u], after, 1e-15);
  EXPECT_NEAR(x[q], start + h * after, 1e-15);
  EXPECT_EQ(now, 2 + h);
}

TEST(fixed_step, asks_for_inputs_where_it_evaluates) {
  std::vector<double> times;
  pendulum::state x(0.3, 0.2);
  double now = 1;
  const auto record = [&](double t, const pendulum::state& at) {
    times.push_back(t);
    return pendulum::inputs(-at[simple_pendulum::u]);
  };
  EXPECT_TRUE(runge_kutta_4<simple_pendulum::System>{}(now, x, 0.5, conservative(), record));
  EXPECT_EQ(times, (std::vector<double>{1, 1.25, 1.25, 1.5}));
  times.clear();
  EXPECT_TRUE(semi_implicit_euler<simple_pendulum::System>{}(now, x, 0.5, conservative(), record));
  EXPECT_EQ(times, std::vector<double>{1.5});
}

// A motor that compensates viscous friction makes a pendulum without friction.
TEST(fixed_step, feeds_the_state_of_each_stage_back) {
  using namespace simple_pendulum;
  pendulum::parameters p = conservative();
  pendulum::state free(0.7, -0.9), driven = free;
  double t1 = 0, t2 = 0;
  const runge_kutta_4<System> step;
  for (int i = 0; i < 50; ++i) {
    p[c] = 0;
    EXPECT_TRUE(step(t1, free, 0.01, p, pendulum::inputs(0.0)));
    p[c] = 3.1;
    EXPECT_TRUE(step(t2, driven, 0.01, p,
                     [&](double, const pendulum::state& at) { return pendulum::inputs(p[c] * at[u]); }));
  }
  EXPECT_LT((free - driven).norm(), 1e-13);
}

// The status of a failing step, which must not change the time and the state.
template <class Step, class Inputs>
std::string refused(Step step, double h, const pendulum::parameters& p, const Inputs& r, double start = 3,
                    const pendulum::state& before = pendulum::state(0.4, 0.5)) {
  pendulum::state x = before;
  double now = start;
  const status s = step(now, x, h, p, r);
  EXPECT_FALSE(s);
  EXPECT_TRUE(x == before || !before.allFinite());
  EXPECT_TRUE(now == start || std::isnan(start));
  return s.cause();
}

TEST(fixed_step, names_what_is_not_finite) {
  using namespace simple_pendulum;
  constexpr double infinite = std::numeric_limits<double>::infinity(),
                   none = std::numeric_limits<double>::quiet_NaN();
  const auto check = [&](auto step) {
    const pendulum::parameters good = conservative();
    const pendulum::inputs still(0.0);
    for (const double wrong : {infinite, -infinite, none}) {
      EXPECT_EQ(refused(step, 0.01, good, pendulum::inputs(wrong)), "T has no finite value");
      EXPECT_EQ(refused(step, 0.01, good, [&](double, const auto&) { return pendulum::inputs(wrong); }),
                "T has no finite value");
      pendulum::parameters p = good;
      p[g] = wrong;
      EXPECT_EQ(refused(step, 0.01, p, still), "g has no finite value");
      EXPECT_EQ(refused(step, 0.01, good, still, 3, {wrong, 0.5}), "q has no finite value");
      EXPECT_EQ(refused(step, 0.01, good, still, 3, {0.4, wrong}), "u has no finite value");
      EXPECT_EQ(refused(step, wrong, good, still), "the step is not finite");
      EXPECT_EQ(refused(step, 0.01, good, still, wrong), "the step is not finite");
    }
    pendulum::parameters p = good;
    p[m] = 0;
    EXPECT_EQ(refused(step, 0.01, p, still),
              "the mass matrix is singular at this state: its elimination fails at the speed u");
  };
  check(runge_kutta_4<System>());
  check(semi_implicit_euler<System>());
  EXPECT_EQ(
      refused(semi_implicit_euler<System>(), 1e300, conservative(), pendulum::inputs(0.0), 3, {0.4, 1e300}),
      "the state after the step is not finite");
}

TEST(fixed_step, takes_no_memory) {
  const pendulum::parameters p = conservative();
  pendulum::state x(0.3, 0.2);
  double now = 0;
  bool good = true;
  {
    no_heap::guard guard;
    good = good && runge_kutta_4<simple_pendulum::System>{}(now, x, 0.01, p, pendulum::inputs(0.1));
    good = good && semi_implicit_euler<simple_pendulum::System>{}(now, x, 0.01, p, pendulum::inputs(0.1));
  }
  EXPECT_TRUE(good);
}

TEST(fixed_step, names_what_was_never_set) {
  using namespace simple_pendulum;
  pendulum::state x{{q, 0.1}, {u, 0}};
  double now = 0;
  pendulum::parameters p = conservative();
  const status no_torque = runge_kutta_4<System>{}(now, x, 0.01, p, pendulum::inputs());
  EXPECT_EQ(no_torque.cause(), "T has no finite value");
  p = {{m, 1}, {l, 2}, {c, 0}};
  const status no_gravity = semi_implicit_euler<System>{}(now, x, 0.01, p, pendulum::inputs(0.0));
  EXPECT_EQ(no_gravity.cause(), "g has no finite value");
  EXPECT_EQ(now, 0);
}

// A state, parameters and inputs of any scalar type.
template <class T, class Step>
kanexpr::state<simple_pendulum::System, T> some_steps(Step step, T start) {
  using lower = kanexpr::lower::scalar_math<T>;
  kanexpr::state<simple_pendulum::System, T> x;
  x(0) = start;
  const pendulum::parameters p = conservative();
  double now = 0;
  for (int i = 0; i < 20; ++i) EXPECT_TRUE(step(now, x, 0.02, p, pendulum::inputs(0.5)));
  EXPECT_TRUE(lower::exceeds(T(x(1) - x(1)), lower::from(-1)));
  return x;
}

TEST(fixed_step, steps_in_single_precision) {
  const auto compare = [](auto step) {
    const auto exact = some_steps<double>(step, 0.6);
    EXPECT_LT((some_steps<float>(step, 0.6f).template cast<double>() - exact).norm(), 1e-5);
  };
  compare(runge_kutta_4<simple_pendulum::System>());
  compare(semi_implicit_euler<simple_pendulum::System>());
  float now = 0; // single precision throughout, as on a controller
  kanexpr::state<simple_pendulum::System, float> x(0.6f, 0.0f);
  const kanexpr::parameter_values<simple_pendulum::System, float> p = conservative().cast<float>();
  const kanexpr::input_values<simple_pendulum::System, float> r(0.5f);
  for (int i = 0; i < 20; ++i) EXPECT_TRUE(runge_kutta_4<simple_pendulum::System>{}(now, x, 0.02f, p, r));
  EXPECT_LT((x.cast<double>() - some_steps<double>(runge_kutta_4<simple_pendulum::System>(), 0.6)).norm(),
            1e-5);
  EXPECT_FLOAT_EQ(now, 0.4f);
}

TEST(fixed_step, steps_states_side_by_side) {
  typedef double pack __attribute__((vector_size(16)));
  const auto compare = [](auto step) {
    const auto all = some_steps<pack>(step, pack{0.1, -1.9});
    for (int lane = 0; lane < 2; ++lane) {
      const double start[]{0.1, -1.9};
      const auto one = some_steps<double>(step, start[lane]);
      for (int i = 0; i < 2; ++i) EXPECT_EQ(all(i)[lane], one(i));
    }
  };
  compare(runge_kutta_4<simple_pendulum::System>());
  compare(semi_implicit_euler<simple_pendulum::System>());
}

constexpr auto one_stage = pendulum::cost(pendulum::rhs);
constexpr auto step_cost = runge_kutta_4<simple_pendulum::System>::cost();
static_assert(one_stage.trigonometric == 1 && one_stage.multiplications > 0);
static_assert(step_cost.trigonometric == 4 && step_cost.nodes == 4 * one_stage.nodes);
static_assert(step_cost.multiplications == 4 * one_stage.multiplications);
static_assert(step_cost.divisions == 4 * one_stage.divisions);
static_assert(semi_implicit_euler<simple_pendulum::System>::cost() == pendulum::cost(pendulum::udot));

} // namespace
