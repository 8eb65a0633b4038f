// builds: clang++ all
// Controllers and prescribed motions, and the derivatives of controllers that stiff methods need.
#include <kanexpr/simulate.hpp>
#include <kanexpr/simulations/prescribe.hpp>

#include <models/simple_pendulum.hpp>

#include <gmock/gmock.h>

#include <cmath>

namespace {

using namespace kanexpr;

namespace on_a_cart { // A pendulum whose pivot is moved to and fro.

constexpr coordinate<"q"> q;
constexpr speed<"u"> u;
constexpr prescribed<"x"> x;
constexpr parameter<"g"> g;
constexpr parameter<"l"> l;

struct N : inertial_frame<N> {}; // y points up
struct A : rotated<A, N, q, N::z> {};
struct O : origin<O, N> {};
struct Pivot : offset<Pivot, O, x * N::x> {};
struct P : offset<P, Pivot, -l * A::y> {};
struct Bob : particle<Bob, P, 1> {};

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, parameters<g, l>,
                            inputs<x, dot(x), dot(dot(x))>, bodies<Bob>, loads<gravity<-g * N::y>>> {};

} // namespace on_a_cart

TEST(inputs, are_prescribed_with_their_derivatives) {
  using namespace on_a_cart;
  const double amplitude = 0.1, frequency = 5;
  const auto by_hand = [&](double t, const state<System>&, input_values<System>& r) {
    r[x] = amplitude * std::sin(frequency * t);
    r[dot(x)] = amplitude * frequency * std::cos(frequency * t);
    r[dot(dot(x))] = -amplitude * frequency * frequency * std::sin(frequency * t);
  };
  const auto derived = [&](double t, const state<System>&, input_values<System>& r) {
    prescribe(r, x, t, [&](auto time) {
      using std::sin;
      return amplitude * sin(frequency * time);
    });
  };
  const auto simulated_with = [](const input_source<System>& inputs) {
    return simulate<System>({{q, 0.2}, {u, 0}}, {{g, 9.81}, {l, 0.5}}, {0, 5},
                            {.inputs = inputs, .relative_tolerance = 1e-12, .absolute_tolerance = 1e-13});
  };
  const auto one = simulated_with(by_hand), other = simulated_with(derived);
  ASSERT_TRUE(one) << one.cause();
  ASSERT_TRUE(other) << other.cause();
  EXPECT_LT((one.state - other.state).norm(), 1e-10);

  // In the frame of the pivot it is a pendulum in oscillating gravity: l q̈ = −g sin q − ẍ cos q.
  double angle = 0.2, rate = 0;
  const int steps = 200000;
  const double dt = 5.0 / steps;
  const auto acceleration = [&](double t, double at) {
    const double pivot = -amplitude * frequency * frequency * std::sin(frequency * t);
    return (-9.81 * std::sin(at) - pivot * std::cos(at)) / 0.5;
  };
  for (int i = 0; i < steps; ++i) { // velocity Verlet
    const double half = rate + dt / 2 * acceleration(i * dt, angle);
    angle += dt * half;
    rate = half + dt / 2 * acceleration((i + 1) * dt, angle);
  }
  EXPECT_NEAR(one.state[q], angle, 1e-8);
  EXPECT_NEAR(one.state[u], rate, 1e-7);
}

TEST(inputs, are_prescribed_with_consistent_rates) {
  using namespace on_a_cart;
  const auto cause = [](const simulation_options<System>& options, double to = 5) {
    return simulate<System>({{q, 0.2}, {u, 0}}, {{g, 9.81}, {l, 0.5}}, {0, to}, options).cause();
  };
  EXPECT_EQ(cause({.inputs = {{x, 1}, {dot(x), 0}, {dot(dot(x)), 0}}}), "");
  EXPECT_EQ(cause({.inputs = {{x, 0}, {dot(x), 2}, {dot(dot(x)), 0}}}),
            "prescribed quantity x is constant, but its rate is given as 2");
  EXPECT_EQ(cause({.inputs = {{x, 0}, {dot(x), 0}, {dot(dot(x)), -1}}}),
            "prescribed quantity dot(x) is constant, but its rate is given as -1");

  const auto given = [](auto value, auto rate, auto second) {
    return [=](double t, const state<System>&, input_values<System>& r) {
      r[x] = value(t), r[dot(x)] = rate(t), r[dot(dot(x))] = second(t);
    };
  };
  const auto zero = [](double) { return 0.0; };
  const auto sine = [](double t) { return std::sin(40 * t); };
  const auto cosine = [](double t) { return 40 * std::cos(40 * t); };
  const auto second = [](double t) { return -1600 * std::sin(40 * t); };
  EXPECT_EQ(cause({.inputs = given([](double t) { return 2 * t; }, zero, zero)}),
            "prescribed quantity x changes at the rate 2 at t = 0.005, but its rate is given as 0");
  EXPECT_EQ(
      cause({.inputs =
                 [](double t) { return input_values<System>{{x, 2 * t}, {dot(x), 0}, {dot(dot(x)), 0}}; }}),
      "prescribed quantity x changes at the rate 2 at t = 0.005, but its rate is given as 0");
  EXPECT_EQ(cause({.inputs = given(sine, cosine, second)}), "");
  EXPECT_THAT(cause({.inputs = given(
                         sine, [&](double t) { return cosine(t) / 40; }, second)}),
              testing::StartsWith("prescribed quantity x changes at the rate "));
  EXPECT_THAT(cause({.inputs = given(sine, cosine, [&](double t) { return -second(t); })}),
              testing::StartsWith("prescribed quantity dot(x) changes at the rate "));
  // A contradiction that occurs only later.
  const auto late = [](double t) { return t > 1 ? (t - 1) * (t - 1) : 0.0; };
  EXPECT_EQ(cause({.inputs = given(late, zero, zero)}),
            "prescribed quantity x changes at the rate 2 at t = 2, but its rate is given as 0");
}

TEST(inputs, are_prescribed_by_tables_with_corners_and_steps) {
  using namespace on_a_cart;
  const auto cause = [](const input_source<System>& inputs) {
    return simulate<System>({{q, 0.2}, {u, 0}}, {{g, 9.81}, {l, 0.5}}, {0, 5},
                            {.inputs = inputs, .relative_tolerance = 1e-4})
        .cause();
  };
  const auto interpolated = [](double t, auto f) { // rows a twentieth of a second apart
    const double row = std::floor(20 * t), part = 20 * t - row;
    return (1 - part) * f(row / 20) + part * f((row + 1) / 20);
  };
  EXPECT_EQ(cause([=](double t, const state<System>&, input_values<System>& r) {
              r[x] = interpolated(t, [](double at) { return std::sin(3 * at); });
              r[dot(x)] = interpolated(t, [](double at) { return 3 * std::cos(3 * at); });
              r[dot(dot(x))] = interpolated(t, [](double at) { return -9 * std::sin(3 * at); });
            }),
            "");
  EXPECT_EQ(cause([](double t, const state<System>&, input_values<System>& r) { // with a corner at 2
              r[x] = std::max(0.0, t - 2), r[dot(x)] = t > 2 ? 1 : 0, r[dot(dot(x))] = 0;
            }),
            "");
  EXPECT_EQ(cause([](double t, const state<System>&, input_values<System>& r) { // held by a computer
              r[x] = std::sin(0.01 * std::floor(100 * t)), r[dot(x)] = std::cos(t),
              r[dot(dot(x))] = -std::sin(t);
            }),
            "");
  EXPECT_EQ(cause([](double t, const state<System>& at, input_values<System>& r) { // along the motion
              r[x] = at[q], r[dot(x)] = at[u], r[dot(dot(x))] = 0 * t;
            }),
            "");
}

namespace controlled {

using namespace simple_pendulum;
const std::initializer_list<named_value> numbers{{m, 1}, {l, 1}, {g, 9.81}, {c, 0}};

// A stiff controller that holds the pendulum at an angle of 0.4: a fast root near −2000/s.
input_values<System> hold(double, const state<System>& now) {
  input_values<System> r;
  r[T] = 9.81 * std::sin(now[q]) + 4000 * (0.4 - now[q]) - 2000 * now[u];
  return r;
}

} // namespace controlled

// T cancels gravity, so q̈ = 4000 (0.4 − q) − 2000 q̇.
TEST(inputs, come_from_a_stiff_controller) {
  using namespace controlled;
  const double root = std::sqrt(1e6 - 4000), slow = -1000 + root, fast = -1000 - root;
  const auto exactly = [&](double t) {
    return 0.4 + (-0.4 * fast * std::exp(slow * t) + 0.4 * slow * std::exp(fast * t)) / (fast - slow);
  };
  const auto check = [&]<integrator by>() {
    const auto run =
        simulate<System, by>({{q, 0}, {u, 0}}, numbers, {0, 2}, {.inputs = hold, .output_every = 0.1});
    ASSERT_TRUE(run) << run.cause();
    for (const auto& s : run.trajectory) EXPECT_NEAR(s.x[q], exactly(s.t), 2e-6) << s.t;
    EXPECT_LT(run.statistics.steps, 1000);
  };
  check.operator()<integrator::bdf>();
  check.operator()<integrator::implicit_runge_kutta>();
  check.operator()<integrator::differential_algebraic>();
}

// The work of a single run depends on chance; over many starts, finite differences cost more.
TEST(inputs, need_fewer_rates_with_exact_derivatives) {
  using namespace controlled;
  const auto count = [](bool exact) {
    long rates = 0;
    for (int i = 1; i <= 30; ++i) {
      const auto run = simulate<System, integrator::bdf>({{q, 0.1 * i}, {u, 0}}, numbers, {0, 10},
                                                         {.inputs = {{T, 0}}, .analytic_jacobian = exact});
      EXPECT_TRUE(run) << run.cause();
      EXPECT_GT(run.statistics.jacobian_evaluations, 5);
      rates += run.statistics.rate_evaluations;
    }
    return rates;
  };
  EXPECT_LT(count(true), count(false));
}

TEST(inputs, are_constants_in_a_vector_of_the_system) {
  using namespace simple_pendulum;
  const auto at_end = [](const simulation_options<System>& options) {
    const auto run = simulate<System>({{q, 0.3}, {u, 0}}, controlled::numbers, {0, 1}, options);
    EXPECT_TRUE(run) << run.cause();
    return run.state;
  };
  input_values<System> r{{T, 0.4}};
  const auto by_name = at_end({.inputs = {{T, 0.4}}});
  EXPECT_EQ(at_end({.inputs = r}), by_name);
  EXPECT_EQ(at_end({.inputs = input_values<System>(0.4)}), by_name);
  EXPECT_EQ(at_end({.inputs = (0.5 * (r + r)).eval()}), by_name);
  EXPECT_EQ(at_end({.inputs = 0.5 * (r + r)}), by_name);
  simulation_options<System> options;
  options.inputs = r;
  EXPECT_EQ(at_end(options), by_name);
}

TEST(inputs, that_a_function_leaves_unset_are_reported) {
  using namespace simple_pendulum;
  const auto run = simulate<System>({{q, 0}, {u, 0}}, controlled::numbers, {0, 1},
                                    {.inputs = [](double, const state<System>&, input_values<System>&) {}});
  EXPECT_FALSE(run);
  EXPECT_THAT(run.cause(), testing::HasSubstr("the input function leaves input T without a finite value"));
}

TEST(inputs, whose_function_throws_end_a_simulation) {
  using namespace simple_pendulum;
  const auto run = simulate<System>({{q, 0.3}, {u, 0}}, controlled::numbers, {0, 9}, {.inputs = [](double t) {
                                      if (t > 1) throw std::runtime_error("no more torque");
                                      return input_values<System>(0.0);
                                    }});
  EXPECT_FALSE(run);
  EXPECT_THAT(run.cause(), testing::EndsWith("the input function threw: no more torque"));
  EXPECT_GT(run.trajectory.size(), 10u);
  EXPECT_LE(run.trajectory.back().t, 1);
  EXPECT_EQ(run.time, run.trajectory.back().t);
}

} // namespace
