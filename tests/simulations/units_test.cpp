// builds: clang++ all
// A pendulum in the two coordinates of its bob, simulated and trimmed in different units.
#include "models/n_pendulum_cart.hpp"
#include "models/pendulum_nonminimal.hpp"

#include <kanexpr/operating_point.hpp>
#include <kanexpr/simulate.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

using namespace pendulum_nonminimal;

template <integrator by = integrator::adams>
simulation<System> swing(double length, double mass, double time) {
  return simulate<System, by>({{q1, 0.9 * length}, {q2, 0.4 * length}, {u1, 0}, {u2, 0}},
                              {{m, mass}, {L, length}, {g, 9.81 * length / (time * time)}}, {0, 5 * time},
                              {.guesses_dependent = true});
}

TEST(units, do_not_matter_to_a_simulation_at_the_defaults) {
  const auto plain = swing(1, 1, 1);
  ASSERT_TRUE(plain) << plain.cause();
  for (const double scale : {0x1p-40, 0x1p40})
    for (const double time : {0x1p-20, 1.0, 0x1p20}) {
      const auto run = swing(scale, scale, time);
      ASSERT_TRUE(run) << run.cause();
      EXPECT_EQ(run.statistics.steps, plain.statistics.steps) << scale << ' ' << time;
      EXPECT_NEAR(run.state[q1] / scale, plain.state[q1], 1e-12) << scale << ' ' << time;
      EXPECT_NEAR(run.state[u2] / scale * time, plain.state[u2], 1e-12) << scale << ' ' << time;
    }
  for (const double scale : {1e-12, 1e-8, 1e-3, 1e6, 1e12}) {
    const auto run = swing(scale, 1, 1);
    ASSERT_TRUE(run) << run.cause();
    EXPECT_NEAR(run.state[q1] / scale, plain.state[q1], 1e-7) << scale;
    EXPECT_NEAR(std::hypot(run.state[q1], run.state[q2]), scale, 1e-13 * scale);
  }
}

// The multipliers are forces, so they also have a unit.
TEST(units, do_not_matter_to_a_differential_algebraic_system) {
  const auto plain = swing<integrator::differential_algebraic>(1, 1, 1);
  ASSERT_TRUE(plain) << plain.cause();
  for (const double length : {1e-12, 1.0, 1e12})
    for (const double mass : {1e-12, 1e12}) {
      const auto run = swing<integrator::differential_algebraic>(length, mass, 1);
      ASSERT_TRUE(run) << run.cause();
      EXPECT_NEAR(run.state[q1] / length, plain.state[q1], 1e-7);
      const auto steps = static_cast<double>(plain.statistics.steps);
      EXPECT_NEAR(static_cast<double>(run.statistics.steps), steps, 0.2 * steps) << length << ' ' << mass;
    }
}

// Only the rod, or a force that acts later, sets the cart in motion.
namespace cart = n_pendulum_cart;
simulation<cart::System<1>> roll(double angle, double length) {
  using rolling = cart::System<1>;
  const auto push = [=](double t, const state<rolling>&, input_values<rolling>& r) {
    r[cart::F] = t > 1 ? length * std::sin(t - 1) : 0;
  };
  return simulate<rolling>({{cart::q<0>, 0}, {cart::q<1>, angle}, {cart::u<0>, 0}, {cart::u<1>, 0}},
                           {{cart::m<0>, 2}, {cart::m<1>, 1}, {cart::l<0>, length}, {cart::g, 9.81 * length}},
                           {0, 5}, {.inputs = push});
}

TEST(units, do_not_matter_to_lengths_next_to_angles) {
  for (const double angle : {0.0, 0.3}) {
    const auto plain = roll(angle, 1);
    ASSERT_TRUE(plain) << plain.cause();
    for (const double length : {0x1p-40, 0x1p-20, 0x1p20, 0x1p40}) {
      const auto run = roll(angle, length);
      EXPECT_EQ(run.statistics.steps, plain.statistics.steps) << length;
      EXPECT_EQ(run.state(0) / length, plain.state(0)) << length;
      EXPECT_EQ(run.state(1), plain.state(1)) << length;
    }
    for (const double length : {1e-12, 1e-9, 1e-6, 1e6, 1e9, 1e12}) {
      const auto run = roll(angle, length);
      EXPECT_NEAR(run.state(0) / length, plain.state(0), 1e-6) << length;
      EXPECT_NEAR(run.state(1), plain.state(1), 1e-6) << length;
    }
  }
}

namespace controlled { // A block whose controller sees lengths only.

constexpr coordinate<"s"> s;
constexpr speed<"v"> v;
constexpr input<"F"> F;

struct O : origin<O, N> {};
struct P : offset<P, O, s * N::x> {};
struct Block : particle<Block, P, 1> {};
struct System : kane_system<inertial<N>, coordinates<s>, speeds<v>, kinematics<dot(s) == v>, inputs<F>,
                            bodies<Block>, loads<force<P, F * N::x>>> {};

simulation<System> held(double length) {
  const auto control = [=](double, const state<System>& x, input_values<System>& r) {
    r[F] = -100 * length * std::tanh(10 * x[s] / length) - 20 * x[v];
  };
  return simulate<System, integrator::bdf>({{s, 0.5 * length}, {v, 0}}, {}, {0, 10}, {.inputs = control});
}

} // namespace controlled

TEST(units, do_not_matter_to_a_controller_of_a_stiff_system) {
  const auto plain = controlled::held(1);
  ASSERT_TRUE(plain) << plain.cause();
  for (const double length : {0x1p-40, 0x1p-20, 0x1p20, 0x1p40}) {
    const auto run = controlled::held(length);
    ASSERT_TRUE(run) << run.cause();
    EXPECT_EQ(run.statistics.steps, plain.statistics.steps) << length;
    EXPECT_EQ(run.statistics.solver_failures, plain.statistics.solver_failures) << length;
    EXPECT_EQ(run.state[controlled::s] / length, plain.state[controlled::s]) << length;
  }
}

TEST(units, do_not_matter_to_a_motion_that_begins_at_rest) {
  for (const double scale : {1e-12, 1.0, 1e12}) {
    const auto hangs = simulate<System>({{q1, scale}, {q2, 0}, {u1, 0}, {u2, 0}},
                                        {{m, 1}, {L, scale}, {g, 9.81}}, {0, 5 * std::sqrt(scale)});
    ASSERT_TRUE(hangs) << hangs.cause();
    EXPECT_NEAR(hangs.state[q1], scale, 1e-14 * scale);
    EXPECT_NEAR(hangs.state[q2], 0, 1e-14 * scale);
  }
}

// A push at the lowest point, where the dependent speed and its rate are zero.
namespace pushed {

constexpr coordinate<"x"> x;
constexpr coordinate<"y"> y;
constexpr speed<"vx"> vx;
constexpr speed<"vy"> vy;
constexpr input<"F"> F;

struct P : offset<P, O, x * N::x + y * N::y> {};
struct Bob : particle<Bob, P, m> {};
struct System
    : kane_system<inertial<N>, coordinates<x, y>, speeds<vx, vy>, kinematics<dot(x) == vx, dot(y) == vy>,
                  bodies<Bob>, configuration_constraints<x * x + y * y == L * L>, dependent<y, vy>,
                  loads<gravity<-g * N::y>, force<P, F * N::x>>> {};

simulation<System> swing(double force, double length, double scale) {
  return simulate<System>({{x, 0}, {y, -length * scale}, {vx, 0}},
                          {{m, 1}, {L, length * scale}, {g, 9.81 * scale}}, {0, 10},
                          {.inputs = {{F, force * scale}}});
}

} // namespace pushed

// The sum of its energy and that of the force stays zero.
TEST(units, do_not_matter_to_a_pendulum_that_is_pushed_from_its_lowest_point) {
  for (const double force : {1e-6, 1e-3, 0.2, 1.0, 50.0})
    for (const double length : {0.5, 0.7, 1.0}) {
      const auto plain = pushed::swing(force, length, 1);
      ASSERT_TRUE(plain) << plain.cause();
      EXPECT_LT(plain.statistics.rate_evaluations, 8000) << force << ' ' << length;
      const auto energy = plain.trajectory.energies().total;
      const auto x = plain.trajectory[pushed::x];
      const double work = force * *std::ranges::max_element(x);
      EXPECT_NEAR(energy.back() - energy.front(), force * plain.state[pushed::x], 1e-5 * work + 1e-14);
      for (const double scale : {0x1p-20, 0x1p20}) {
        const auto run = pushed::swing(force, length, scale);
        ASSERT_TRUE(run) << run.cause();
        EXPECT_EQ(run.statistics.steps, plain.statistics.steps);
        EXPECT_EQ(run.state[pushed::x] / scale, plain.state[pushed::x]);
      }
    }
}

constexpr double scales[]{1e-12, 1e-9, 1e-6, 1e-3, 1.0, 1e3, 1e6, 1e9, 1e12};

operating_point<System> rest(double length, double mass, double time,
                             const operating_point_options<System>& options = {}) {
  return operating_point<System>({{q1, 0.8 * length}, {q2, 0.3 * length}, {u1, 0}, {u2, 0}},
                                 {{m, mass}, {L, length}, {g, 9.81 * length / (time * time)}}, options);
}

TEST(units, do_not_matter_to_an_operating_point) {
  const auto plain = rest(1, 1, 1);
  for (const double length : scales)
    for (const double other : {1e-12, 1.0, 1e12}) {
      const auto found = rest(length, other, other);
      ASSERT_TRUE(found) << length << ' ' << other << ' ' << found.cause();
      EXPECT_NEAR(found.x[q1], length, 1e-12 * length);
      EXPECT_NEAR(found.x[q2], 0, 1e-12 * length);
      EXPECT_EQ(found.freedom, plain.freedom);
    }
  for (const double length : {0x1p-40, 0x1p40})
    for (const double other : {0x1p-40, 0x1p40}) { // to the last bit
      const auto found = rest(length, other, other);
      EXPECT_EQ(found.iterations, plain.iterations) << length << ' ' << other;
      EXPECT_EQ(found.x[q2] / length, plain.x[q2]);
    }
  for (const double length : scales) { // at its position from the start, with unchanged gravity
    const operating_point<System> hangs({{q1, length}, {q2, 0}, {u1, 0}, {u2, 0}},
                                        {{m, 1}, {L, length}, {g, 9.81}});
    EXPECT_TRUE(hangs) << hangs.cause();
    EXPECT_EQ(hangs.freedom, 0);
  }
}

TEST(units, do_not_matter_if_there_is_no_operating_point) {
  for (const double length : scales)
    for (const double other : {1e-12, 1.0, 1e12}) {
      const auto none = rest(length, other, other, {.held = {q2}});
      EXPECT_FALSE(none) << length << ' ' << other << ' ' << none.x.transpose();
    }
}

} // namespace
