// builds: clang++ all
// Steps of fixed length with constraints that are not linear in the speeds.
#include "runtime/agreement.hpp"
#include "steps/derivatives_of_steps.hpp"

#include <kanexpr/assemble.hpp>
#include <kanexpr/batch.hpp>
#include <kanexpr/fixed_step.hpp>
#include <kanexpr/runtime/assemble.hpp>
#include <models/appell_hamel.hpp>

#include <cmath>

namespace {

using namespace appell_hamel;
using eom = equations_of_motion<System>;

constexpr double slope = 0.7, strength = 9.81;

const input_values<System> none(0.0);

parameter_values<System> numbers() { return {{m, 1.3}, {a, slope}, {g, strength}}; }

/// A state with this vertical speed; the horizontal velocity points along x.
state<System> rising(double speed) {
  return {{x, 0}, {y, 0}, {z, 0}, {u, slope * speed}, {v, 0}, {w, speed}};
}

static_assert(eom::is_dependent(w) && !eom::is_dependent(u));

TEST(nonlinear_constraints, are_the_same_in_the_compiler) {
  auto derived = derive<System>();
  auto rates = derived.function(derived.rhs());
  std::mt19937_64 source(5);
  for (int i = 0; i < 20; ++i) {
    const auto at = agreement::random<state<System>>(source, -2, 2);
    const input_values<System> r(0.3 * i);
    agreement::expect_same_bits(eom::rhs(at, numbers(), r), rates(0, at, numbers(), r));
  }
}

TEST(nonlinear_constraints, are_assembled_on_the_side_of_the_guess) {
  auto derived = derive<System>();
  for (const double guess : {-3.0, -0.1, 0.1, 3.0}) {
    state<System> at = rising(0);
    at[u] = 0.6, at[v] = -0.8, at[w] = guess;
    state<System> compiled = at;
    Eigen::VectorXd interpreted = at;
    const assembly done = [&] {
      const no_heap::guard guard;
      return assemble<System>(compiled, numbers(), none);
    }();
    ASSERT_TRUE(done) << done.cause();
    EXPECT_GT(done.steps, 1);
    EXPECT_NEAR(compiled[w], std::copysign(1 / slope, guess), 1e-15);
    EXPECT_EQ(compiled[u], 0.6);
    ASSERT_TRUE(kanexpr::assemble(derived, interpreted, numbers(), none));
    EXPECT_LE((interpreted - compiled).norm(), 1e-15);
    EXPECT_TRUE(check_consistency<System>(compiled, numbers(), none));
    EXPECT_FALSE(check_consistency<System>(at, numbers(), none));
  }
}

TEST(nonlinear_constraints, are_not_assembled_where_their_derivatives_vanish) {
  auto derived = derive<System>();
  state<System> at = rising(1);
  at[w] = 0;
  const assembly done = assemble<System>(at, numbers(), none);
  EXPECT_EQ(done.cause(),
            "the search for the dependent speeds ended at a singularity of the velocity constraints, "
            "with a residual of 0.49");
  EXPECT_EQ(at[w], 0);
  Eigen::VectorXd same = at;
  EXPECT_EQ(kanexpr::assemble(derived, same, numbers(), none).cause(), done.cause());
  EXPECT_EQ(eom::udot(at, numbers(), none).status.cause(),
            "the constraints cannot be solved for the dependent speed w at this state");
}

template <class Step>
state<System> after(double duration, double h, double from) {
  state<System> at = rising(from);
  double t = 0;
  const auto p = numbers();
  const no_heap::guard guard;
  while (t < duration - h / 2) {
    const status s = Step{}(t, at, h, p, none);
    EXPECT_TRUE(s) << s.cause();
    if (!s) break;
  }
  return at;
}

TEST(nonlinear_constraints, are_kept_by_steps) {
  using step = runge_kutta_4<System>;
  const double from = 9, change = -strength / (1 + slope * slope);
  const state<System> end = after<step>(1, 1e-3, from);
  EXPECT_NEAR(end[z], from + change / 2, 1e-12);
  EXPECT_NEAR(end[w], from + change, 1e-12);
  EXPECT_NEAR(end[u], slope * end[w], 1e-13);
  EXPECT_TRUE(check_consistency<System>(end, numbers(), none, 0, 1e-13));
}

// One Newton step for the speeds per correction.
TEST(nonlinear_constraints, take_as_many_corrections_as_requested) {
  const auto left = [](const state<System>& at) {
    return std::abs(eom::velocity_residual(at, numbers(), none)(0));
  };
  const double uncorrected = left(after<semi_implicit_euler<System, 0>>(1, 0.02, 9)),
               once = left(after<semi_implicit_euler<System, 1>>(1, 0.02, 9)),
               twice = left(after<semi_implicit_euler<System, 2>>(1, 0.02, 9));
  EXPECT_GT(uncorrected, 1e-14);
  EXPECT_LE(twice, once);
  EXPECT_LE(twice, 1e-13);
  using symbolic::cost;
  constexpr cost one = steps::correction<System, 1>::cost(), two = steps::correction<System, 2>::cost();
  EXPECT_EQ(two.multiplications, 2 * one.multiplications);
}

TEST(nonlinear_constraints, carry_derivatives_through_steps) {
  step_checks::point<System> at;
  at.x = rising(9), at.p = numbers();
  step_checks::expect_derivatives<runge_kutta_4<System>>(at, 0.5);
  step_checks::expect_derivatives<semi_implicit_euler<System, 2>>(at, 0.5);
}

TEST(nonlinear_constraints, are_kept_in_batches_and_in_single_precision) {
  using side_by_side = batch<4, float>;
  side_by_side::state<System> all;
  for (std::size_t lane = 0; lane < 4; ++lane) {
    const float speed = 9 + static_cast<float>(lane);
    side_by_side::set(all, lane, {{x, 0}, {y, 0}, {z, 0}, {u, float(slope) * speed}, {v, 0}, {w, speed}});
  }
  const parameter_values<System, float> p{{m, 1.3f}, {a, float(slope)}, {g, float(strength)}};
  const input_values<System, float> still(0.0f);
  float t = 0;
  runge_kutta_4<System> step;
  for (int i = 0; i < 1000; ++i) ASSERT_TRUE(step(t, all, 1e-3f, p, still));
  for (std::size_t lane = 0; lane < 4; ++lane) {
    const state<System, float> end = side_by_side::get(all, lane);
    EXPECT_NEAR(end[w], 9 + static_cast<double>(lane) - strength / 1.49, 1e-3);
    EXPECT_NEAR(std::abs(end[u] / end[w]), slope, 1e-5);
  }
}

// A particle with constant speed c = 3 in a vertical plane, solved for its vertical speed, which passes
// through zero at the top: sin θ = −tanh(g t/c + τ₀) for the direction θ of the velocity.
namespace constant_speed {

struct Q : offset<Q, O, x * N::x + z * N::z> {};
struct Bead : particle<Bead, Q, 2> {};
struct System : kane_system<inertial<N>, coordinates<x, z>, speeds<u, w>,
                            kinematics<dot(x) == u, dot(z) == w>, velocity_constraints<u * u + w * w == 9>,
                            dependent<w>, bodies<Bead>, loads<gravity<-9 * N::z>>> {};

} // namespace constant_speed

TEST(nonlinear_constraints, are_passed_where_the_dependent_speed_vanishes) {
  using constant_speed::System;
  const kanexpr::state<System> start{{x, 0}, {z, 0}, {u, 3 / std::cosh(1)}, {w, 3 * std::tanh(1)}};
  const double h = 1e-3;
  kanexpr::state<System> at = start;
  double t = 0;
  status s;
  while (s && t < 0.5) s = runge_kutta_4<System>{}(t, at, h);
  EXPECT_EQ(s.cause(), steps::singular_position);
  EXPECT_NEAR(t, 1.0 / 3, 3 * h);
  at = start, t = 0, s = {};
  while (s && t < 1 - h / 2) s = passing<runge_kutta_4<System>>{}(t, at, h);
  ASSERT_TRUE(s) << s.cause();
  EXPECT_NEAR(at[u], 3 / std::cosh(2), 1e-9);
  EXPECT_NEAR(at[w], -3 * std::tanh(2), 1e-9);
  EXPECT_NEAR(at[z], -std::log(std::cosh(2) / std::cosh(1)), 1e-9);
  EXPECT_TRUE(check_consistency<System>(at, {}, {}, 0, 1e-12));
}

} // namespace
