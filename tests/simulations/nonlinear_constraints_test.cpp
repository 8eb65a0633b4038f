// builds: clang++ all
// Motions with constraints that are not linear in the speeds, compared with closed forms.
#include <kanexpr/runtime/builder.hpp>
#include <kanexpr/simulations/model.hpp>
#include <kanexpr/symbolic/graph/functions.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace {

using namespace kanexpr;
using runtime::builder;
using symbolic::expression;

constexpr double mass = 1.3, strength = 9.81;

// A particle in a vertical plane; z points up.
struct in_plane : builder {
  expression x = coordinate("x"), z = coordinate("z"), u = speed("u"), w = speed("w"), m = parameter("m"),
             g = parameter("g"), c = parameter("c");
  runtime::frame_id n = inertial_frame();
  runtime::point_id p = offset("P", origin("O"), along(n, x, 0, z));

  in_plane() : builder("N") {
    kinematic_equation(dot(x) - u), kinematic_equation(dot(z) - w);
    particle("P", p, m);
    gravity(along(n, 0.0, 0.0, -g));
  }
};

// The speed is c. The direction θ of the velocity obeys θ' = −(g/c) cos θ; hence sin θ = −tanh τ with τ = g
// t/c + τ₀.
struct constant_speed : in_plane {
  explicit constant_speed(bool is_w_dependent) {
    velocity_constraint(u * u + w * w - c * c);
    dependent(is_w_dependent ? w : u);
  }
  static Eigen::Vector4d at(double t, double c, double start) {
    const double from = -std::atanh(start), now = strength * t / c + from;
    const auto gudermannian = [](double tau) { return std::atan(std::sinh(tau)); };
    return {c * c / strength * (gudermannian(now) - gudermannian(from)),
            -c * c / strength * std::log(std::cosh(now) / std::cosh(from)), c / std::cosh(now),
            -c * std::tanh(now)};
  }
};

// The power of gravity and of a drag of c per speed is constant: a servo holds the total power of the forces
// against which it works. The velocity relative to −m g/(2c) along z has a constant magnitude R, and its
// direction obeys θ' = −(g/2R) cos θ.
struct constant_power : in_plane {
  static constexpr double power = 20;
  constant_power() {
    force(p, along(n, -c * u, 0, -c * w));
    velocity_constraint(m * g * w + c * (u * u + w * w) - power);
    dependent(u);
  }
  static Eigen::Vector4d at(double t, double c, double start) {
    const double drift = mass * strength / (2 * c), radius = std::sqrt(power / c + drift * drift),
                 from = -std::atanh(start), now = strength * t / (2 * radius) + from;
    const auto gudermannian = [](double tau) { return std::atan(std::sinh(tau)); };
    const double length = 2 * radius * radius / strength;
    return {length * (gudermannian(now) - gudermannian(from)),
            -length * std::log(std::cosh(now) / std::cosh(from)) - drift * t, radius / std::cosh(now),
            -radius * std::tanh(now) - drift};
  }
};

template <integrator by, class Motion>
void expect_motion(const Motion& built, double c, double start, double duration, bool has_samples = true) {
  SCOPED_TRACE("integrator " + std::to_string(static_cast<int>(by)));
  const Eigen::Vector4d x = Motion::at(0, c, start);
  const auto run = simulate<by>(built, {{"x", 0}, {"z", 0}, {"u", x(2)}, {"w", x(3)}},
                                {{"m", mass}, {"g", strength}, {"c", c}}, {0, duration},
                                {.relative_tolerance = 1e-10,
                                 .absolute_tolerance = 1e-11,
                                 .output_every = has_samples ? duration / 50 : 0});
  ASSERT_TRUE(run) << run.cause();
  for (std::size_t i = 0; i < run.trajectory.size(); ++i) {
    const auto& sample = run.trajectory[i];
    const Eigen::Vector4d wanted = Motion::at(sample.t, c, start);
    EXPECT_LE((Eigen::Vector4d(sample.x) - wanted).norm(), 1e-7 * (1 + wanted.norm()))
        << "at t = " << sample.t;
  }
  EXPECT_LE(std::ranges::max(run.trajectory.constraint_residuals()), 1e-10 * c * c);
}

template <class Motion>
void expect_motion_by_each(const Motion& built, double c, double start, double duration) {
  expect_motion<integrator::adams>(built, c, start, duration);
  expect_motion<integrator::bdf>(built, c, start, duration);
  expect_motion<integrator::explicit_runge_kutta>(built, c, start, duration);
  expect_motion<integrator::implicit_runge_kutta>(built, c, start, duration);
  expect_motion<integrator::differential_algebraic>(built, c, start, duration);
}

TEST(nonlinear_constraints, keep_the_speed) { expect_motion_by_each(constant_speed(false), 3, 0.9, 1); }
// The same motion with a state variable, which decays on its own.
struct constant_speed_with_memory : constant_speed {
  constant_speed_with_memory() : constant_speed(false) {
    const expression memory = state_variable("memory");
    dynamics(memory, -memory / 0.3);
  }
};

template <integrator by>
void expect_motion_and_memory() {
  const double c = 3, duration = 0.8;
  const Eigen::Vector4d x = constant_speed::at(0, c, 0.9), end = constant_speed::at(duration, c, 0.9);
  const auto run = simulate<by>(constant_speed_with_memory(),
                                {{"x", 0}, {"z", 0}, {"u", x(2)}, {"w", x(3)}, {"memory", 2}},
                                {{"m", mass}, {"g", strength}, {"c", c}}, {0, duration},
                                {.relative_tolerance = 1e-10, .absolute_tolerance = 1e-11});
  ASSERT_TRUE(run) << run.cause();
  const Eigen::VectorXd last = run.trajectory[run.trajectory.size() - 1].x;
  EXPECT_LE((last.head(4) - end).norm(), 1e-7);
  EXPECT_NEAR(last(4), 2 * std::exp(-duration / 0.3), 1e-8);
}

TEST(nonlinear_constraints, keep_the_speed_with_a_state_variable) {
  expect_motion_and_memory<integrator::adams>();
  expect_motion_and_memory<integrator::implicit_runge_kutta>();
  expect_motion_and_memory<integrator::differential_algebraic>();
}

// The vertical speed passes through zero, where the constraint cannot be solved for it.
TEST(nonlinear_constraints, pass_where_the_dependent_speed_cannot_be_solved_for) {
  expect_motion_by_each(constant_speed(true), 3, 0.9, 1);
}
// The horizontal speed decays to nothing.
TEST(nonlinear_constraints, outlast_the_dependent_speed) {
  expect_motion<integrator::adams>(constant_speed(false), 3, 0.9, 40);
}
TEST(nonlinear_constraints, begin_where_the_dependent_speed_cannot_be_solved_for) {
  expect_motion_by_each(constant_speed(true), 3, 0, 1);
}
TEST(nonlinear_constraints, keep_the_power) { expect_motion_by_each(constant_power(), 0.8, 0.8, 3); }

// A particle in space; z points up.
struct in_space : builder {
  expression x = coordinate("x"), y = coordinate("y"), z = coordinate("z"), u = speed("u"), v = speed("v"),
             w = speed("w"), m = parameter("m"), g = parameter("g"), a = parameter("a"), k = parameter("k");
  runtime::frame_id n = inertial_frame();
  runtime::point_id p = offset("P", origin("O"), along(n, x, y, z));

  in_space() : builder("N") {
    kinematic_equation(dot(x) - u), kinematic_equation(dot(y) - v), kinematic_equation(dot(z) - w);
    particle("P", p, m);
    gravity(along(n, 0.0, 0.0, -g));
  }
};

// Appell and Hamel's example, ẋ² + ẏ² = a² ż², with a horizontal force k ẑ × v. The constraint divides
// gravity between the vertical and the horizontal motion, z'' = −g/(1 + a²), and the force turns the latter
// at the rate k/m. Hamel, Theoretische Mechanik (1949), section VIII; Neimark & Fufaev, Dynamics of
// Nonholonomic Systems (1972), chapter IV.
struct appell_hamel : in_space {
  appell_hamel() {
    force(p, along(n, -k * v, k * u, 0));
    velocity_constraint(u * u + v * v - a * a * w * w);
  }
};

template <integrator by>
void expect_appell_hamel() {
  SCOPED_TRACE("integrator " + std::to_string(static_cast<int>(by)));
  const double slope = 0.7, turn = 2.5, from = 9, change = -strength / (1 + slope * slope);
  const auto run =
      simulate<by>(appell_hamel(), {{"x", 0}, {"y", 0}, {"z", 0}, {"u", slope * from}, {"v", 0}, {"w", from}},
                   {{"m", mass}, {"g", strength}, {"a", slope}, {"k", mass * turn}}, {0, 1},
                   {.relative_tolerance = 1e-10, .absolute_tolerance = 1e-11, .output_every = 0.02});
  ASSERT_TRUE(run) << run.cause();
  for (std::size_t i = 0; i < run.trajectory.size(); ++i) {
    const auto& sample = run.trajectory[i];
    const double t = sample.t, c = std::cos(turn * t), s = std::sin(turn * t), w = from + change * t;
    const double x = slope * (w * s / turn + change * (c - 1) / (turn * turn)),
                 y = slope * ((from - w * c) / turn + change * s / (turn * turn));
    Eigen::Vector<double, 6> wanted;
    wanted << x, y, from * t + change * t * t / 2, slope * w * c, slope * w * s, w;
    EXPECT_LE((Eigen::Vector<double, 6>(sample.x) - wanted).norm(), 1e-7) << "at t = " << t;
  }
  EXPECT_LE(std::ranges::max(run.trajectory.constraint_residuals()), 1e-10);
}

TEST(nonlinear_constraints, divide_gravity_in_the_example_of_appell_and_hamel) {
  expect_appell_hamel<integrator::adams>();
  expect_appell_hamel<integrator::bdf>();
  expect_appell_hamel<integrator::explicit_runge_kutta>();
  expect_appell_hamel<integrator::implicit_runge_kutta>();
  expect_appell_hamel<integrator::differential_algebraic>();
}

// At the apex of the cone of velocities, all derivatives of the constraint vanish. The motion continues in
// the opposite direction.
TEST(nonlinear_constraints, pass_the_apex_of_the_cone_of_velocities) {
  const auto run = simulate(appell_hamel(), {{"x", 0}, {"y", 0}, {"z", 0}, {"u", 0.7}, {"v", 0}, {"w", 1}},
                            {{"m", 1}, {"g", 9.81}, {"a", 0.7}, {"k", 0}}, {0, 1});
  ASSERT_TRUE(run) << run.cause();
  EXPECT_NEAR(run.state["w"], 1 - 9.81 / 1.49, 1e-6);
  EXPECT_NEAR(run.state["u"], 0.7 * run.state["w"], 1e-9);
  EXPECT_NEAR(run.state["x"], 0.7 * run.state["z"], 1e-7);
}

TEST(nonlinear_constraints, do_not_determine_a_motion_from_rest) {
  const auto run = simulate(appell_hamel(), {{"x", 0}, {"y", 0}, {"z", 0}, {"u", 0}, {"v", 0}, {"w", 0}},
                            {{"m", 1}, {"g", 9.81}, {"a", 0.7}, {"k", 0}}, {0, 1});
  EXPECT_FALSE(run);
  EXPECT_EQ(run.cause(),
            "the simulation ended at t = 0 with x = 0, y = 0, z = 0, u = 0, v = 0, w = 0: the equations of "
            "motion could not be evaluated: the constraints are dependent or inconsistent near this state");
}

// A particle on anisotropic springs moves with constant speed; its motion is irregular.
TEST(nonlinear_constraints, drift_nowhere_in_a_long_motion) {
  struct on_springs : in_space {
    on_springs() {
      force(p, along(n, -k * x, -2.3 * k * y, -3.7 * k * z * z * z));
      velocity_constraint(u * u + v * v + w * w - a * a);
    }
  };
  const auto run =
      simulate(on_springs(), {{"x", 0.3}, {"y", 0}, {"z", -0.2}, {"u", 1.2}, {"v", 0.9}, {"w", 0}},
               {{"m", 1}, {"g", 1}, {"a", 1.5}, {"k", 4}}, {0, 1000},
               {.guesses_dependent = true, .relative_tolerance = 1e-8, .output_every = 0.5});
  ASSERT_TRUE(run) << run.cause();
  EXPECT_EQ(run.trajectory.size(), 2001u);
  EXPECT_LE(std::ranges::max(run.trajectory.constraint_residuals()), 1e-10);
}

} // namespace
