// builds: clang++ all
// Filters, delays, controllers, muscle activations and DC motors of models, compared with their equations and
// with closed forms.
#include <kanexpr/blocks.hpp>
#include <kanexpr/fixed_step.hpp>
#include <kanexpr/joints.hpp>
#include <kanexpr/kanexpr.hpp>
#include <kanexpr/runtime/builder.hpp>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <string>

namespace blocks_on_a_cart {

using namespace kanexpr;

constexpr coordinate<"q"> q;
constexpr speed<"u"> u;
constexpr parameter<"T"> T;
constexpr parameter<"kp"> kp;
constexpr parameter<"ki"> ki;
constexpr parameter<"kd"> kd;
constexpr input<"r"> r;

struct N : inertial_frame<N> {};
struct O : origin<O, N> {};
struct P : offset<P, O, q * N::x> {};
struct Cart : particle<Cart, P, 2> {};

struct Filter : lag<Filter, r, T> {};
struct Late : delay<Late, 6, Filter::output, T> {};
struct Controller : pid<Controller, Late::output - q, kp, ki, kd, 0.1> {};
struct Limited : pid<Limited, r - q, kp, ki, kd, 0.1, -3, 5, 0.5> {};
struct Proportional : pid<Proportional, r - q, kp, ki> {};
struct Bounded : pid<Bounded, r - q, kp, ki, -3, 5, 0.5> {};
struct Valve : slew_limit<Valve, Limited::output, 2.0, 0.05> {};
struct Muscle : muscle_activation<Muscle, r, 0.015, 0.06> {};

struct System
    : kane_system<
          inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Cart>,
          parameters<T, kp, ki, kd>, inputs<r>,
          blocks<Filter, Late, Controller, Limited, Valve, Muscle, Proportional, Bounded>,
          loads<
              force<P, 1e-6 * (Controller::output + Valve::output + Proportional::output + Bounded::output) *
                           N::x>>> {};

} // namespace blocks_on_a_cart

namespace motors {

using namespace kanexpr;

constexpr parameter<"J"> J;
constexpr input<"V"> V;
struct N : inertial_ground<N> {};
struct Wheel : pin<Wheel, N, axis<N::z>, body<1, 0.1 * own::z, inertia<own, J, J, J>>> {};
struct System : kane_system<inertial<N>, joints<Wheel>, loads<dc_motor<Wheel, V, 2, 0.01, 0.1, 10, 0.02>>> {};
struct WarmSystem : kane_system<inertial<N>, joints<Wheel>,
                                loads<dc_motor<Wheel, V, 2, 0.01, 0.1, 10, 0.02, 0.01, 0.004, 30, 1.5>>> {};

} // namespace motors

namespace {

using namespace blocks_on_a_cart;
using eom = kanexpr::equations_of_motion<System>;

kanexpr::parameter_values<System> some_parameters() { return {{T, 0.4}, {kp, 3}, {ki, 0.7}, {kd, 0.2}}; }

kanexpr::state<System> some_state() {
  kanexpr::state<System> x;
  for (int i = 0; i < x.size(); ++i) x(i) = std::sin(3 * i + 1);
  x[Muscle::output] = 0.4;
  return x;
}

TEST(blocks, add_state_variables) {
  EXPECT_EQ(eom::state_variables, 1 + 6 + 2 + 2 + 1 + 1 + 1 + 1);
  EXPECT_EQ(std::string(kanexpr::derivation::stages_of<System>::constrained.known.names[2].view()),
            "y_Filter");
  EXPECT_EQ(std::string(kanexpr::derivation::stages_of<System>::constrained.known.names[3].view()),
            "m_Late1");
}

TEST(blocks, follow_their_equations) {
  const auto x = some_state();
  const auto p = some_parameters();
  const double input = 1.3;
  const kanexpr::input_values<System> given{{r, input}};
  using kanexpr::state_variable;
  const auto [lag_rate, s, d, muscle, valve, limited_s] =
      kanexpr::function<System, dot(Filter::output), dot(state_variable<"s_Controller">{}),
                        dot(state_variable<"d_Controller">{}), dot(Muscle::output), dot(Valve::output),
                        dot(state_variable<"s_Limited">{})>{}(x, p, given);
  EXPECT_NEAR(lag_rate, (input - x[Filter::output]) / 0.4, 1e-14);
  double late = 0;
  for (int i = 3; i < 9; ++i) late += x(i);
  const double e = late - x[q];
  EXPECT_NEAR(s, 0.7 * e, 1e-14);
  EXPECT_NEAR(d, (e - x[state_variable<"d_Controller">{}]) / 0.1, 1e-13);
  const double a = 0.4, f = 0.5 * std::tanh(10 * (input - a));
  EXPECT_NEAR(muscle,
              ((0.5 + f) / (0.015 * (0.5 + 1.5 * a)) + (0.5 - f) * (0.5 + 1.5 * a) / 0.06) * (input - a),
              1e-11);
  const auto softplus = [](double v, double width) { return width * std::log1p(std::exp(v / width)); };
  const double of_limited = input - x[q];
  const double v = 3 * of_limited + x[state_variable<"s_Limited">{}] +
                   0.2 * (of_limited - x[state_variable<"d_Limited">{}]) / 0.1;
  const double limited = -3 + softplus(v + 3, 0.08) - softplus(v - 5, 0.08);
  EXPECT_NEAR(limited_s, 0.7 * of_limited + (limited - v) / 0.5, 1e-12); // does not wind up
  EXPECT_NEAR(valve, 2 * std::tanh((limited - x[Valve::output]) / (2 * 0.05)), 1e-13);
}

// The same system from a builder has the same state variables and rates.
TEST(blocks, are_those_of_a_builder) {
  namespace runtime = kanexpr::runtime;
  runtime::builder b("N");
  const auto position = b.coordinate("q"), velocity = b.speed("u"), time = b.parameter("T"),
             p = b.parameter("kp"), i = b.parameter("ki"), d = b.parameter("kd"), reference = b.input("r");
  b.kinematic_equation(b.dot(position) - velocity);
  const runtime::frame_id n = b.inertial_frame();
  const runtime::point_id at = b.offset("P", b.origin("O"), b.along(n, position, 0, 0));
  b.particle("Cart", at, b.number(2));
  const auto filtered = b.lag("Filter", reference, time), late = b.delay("Late", 6, filtered, time),
             controlled = b.pid("Controller", late - position, p, i, d, 0.1),
             limited = b.pid("Limited", reference - position, p, i, d, 0.1, -3, 5, 0.5),
             followed = b.slew_limit("Valve", limited, 2.0, 0.05);
  b.muscle_activation("Muscle", reference, 0.015, 0.06);
  const auto proportional = b.pid("Proportional", reference - position, p, i),
             bounded = b.pid("Bounded", reference - position, p, i, -3, 5, 0.5);
  b.force(at, b.along(n, 1e-6 * (controlled + followed + proportional + bounded), 0, 0));
  auto model = kanexpr::derive(b);
  ASSERT_EQ(model.mistake(), "");
  const auto x = some_state();
  const Eigen::VectorXd rates = model.function(model.get(kanexpr::mechanics::quantity::rhs))(
                            x, some_parameters(), Eigen::VectorXd::Constant(1, 1.3)),
                        expected = eom::rhs(x, some_parameters(), kanexpr::input_values<System>{{r, 1.3}});
  ASSERT_EQ(rates.size(), expected.size());
  for (Eigen::Index k = 0; k < rates.size(); ++k)
    EXPECT_NEAR(rates(k), expected(k), 1e-14 * (1 + std::abs(expected(k)))) << k;
}

/// Without a derivative, the controller has neither its time constant nor its filter.
TEST(blocks, have_pi_controllers) {
  const auto x = some_state();
  using kanexpr::state_variable;
  const auto [output, rate, bounded, bounded_rate] =
      kanexpr::function<System, Proportional::output, dot(state_variable<"s_Proportional">{}),
                        Bounded::output, dot(state_variable<"s_Bounded">{})>{}(
          x, some_parameters(), kanexpr::input_values<System>{{r, 1.3}});
  const double e = 1.3 - x[q], softened = 0.08;
  EXPECT_NEAR(output, 3 * e + x[state_variable<"s_Proportional">{}], 1e-14);
  EXPECT_NEAR(rate, 0.7 * e, 1e-14);
  const auto softplus = [&](double v) { return softened * std::log1p(std::exp(v / softened)); };
  const double v = 3 * e + x[state_variable<"s_Bounded">{}], limited = -3 + softplus(v + 3) - softplus(v - 5);
  EXPECT_NEAR(bounded, limited, 1e-13);
  EXPECT_NEAR(bounded_rate, 0.7 * e + (limited - v) / 0.5, 1e-12);
}

double factorial(int k) { return std::tgamma(k + 1.0); }

/// The Padé approximant of e^(−s) of degree n − 1 above and n below.
std::complex<double> pade(int n, std::complex<double> s) {
  std::complex<double> above = 0, below = 0;
  for (int k = 0; k <= n; ++k) {
    const double common = factorial(2 * n - 1 - k) / factorial(k);
    if (k < n) above += common * factorial(n - 1) / factorial(n - 1 - k) * std::pow(-s, k);
    below += common * factorial(n) / factorial(n - k) * std::pow(s, k);
  }
  return above / below;
}

/// The transfer function of the delay from its state matrix.
TEST(blocks, delay_by_pade) {
  constexpr int n = 6;
  const auto [A, B] = kanexpr::linearization<System>::explicit_form(some_state(), some_parameters(),
                                                                    kanexpr::input_values<System>{{r, 1}});
  const Eigen::Matrix<double, n, n> own = A.block<n, n>(3, 3);
  const Eigen::Vector<double, n> by_filter = A.block<n, 1>(3, 2);
  for (const std::complex<double> s : {std::complex<double>(0.3, 2), std::complex<double>(0, 5)}) {
    const Eigen::Matrix<std::complex<double>, n, n> left =
        s / 0.4 * Eigen::Matrix<std::complex<double>, n, n>::Identity() - own;
    const std::complex<double> found = left.lu().solve(by_filter.cast<std::complex<double>>()).sum();
    EXPECT_LE(std::abs(found - pade(n, s)), 1e-12);
  }
}

/// The same for every order, from the equations of a builder.
TEST(blocks, delay_by_pade_of_every_order) {
  using kanexpr::symbolic::matrix;
  for (int n = 1; n <= 9; ++n) {
    SCOPED_TRACE(n);
    kanexpr::runtime::builder b("N");
    const auto at = b.coordinate("q"), velocity = b.speed("u"), given = b.input("r"), time = b.parameter("T");
    b.kinematic_equation(b.dot(at) - velocity);
    const auto point = b.offset("P", b.origin("O"), b.along(b.inertial_frame(), at, 0, 0));
    b.particle("Cart", point, b.number(2));
    const auto late = b.delay("Late", n, given, time);
    b.force(point, b.along(b.inertial_frame(), late, 0, 0));
    auto model = kanexpr::derive(b);
    ASSERT_EQ(model.mistake(), "");
    auto rates = model.function(model.get(kanexpr::mechanics::quantity::rhs));
    matrix output(b.graph(), 1, 1);
    output(0, 0) = late;
    auto result = model.function(output);
    const double T_given = 0.4;
    const Eigen::VectorXd p = Eigen::VectorXd::Constant(1, T_given), none = Eigen::VectorXd::Zero(1),
                          one = Eigen::VectorXd::Ones(1);
    const Eigen::VectorXd rest = Eigen::VectorXd::Zero(2 + n);
    // the equations are linear, so their matrices are differences
    const Eigen::VectorXcd by_input =
        Eigen::VectorXd(Eigen::VectorXd(rates(rest, p, one)) - Eigen::VectorXd(rates(rest, p, none)))
            .tail(n)
            .cast<std::complex<double>>();
    Eigen::MatrixXcd own(n, n), seen(1, n);
    for (int k = 0; k < n; ++k) {
      Eigen::VectorXd x = rest;
      x(2 + k) = 1;
      own.col(k) = Eigen::VectorXd(rates(x, p, none)).tail(n).cast<std::complex<double>>();
      seen(0, k) = result(x, p, none)(0);
    }
    for (const std::complex<double> s : {std::complex<double>(0.3, 2), std::complex<double>(0, 5)}) {
      const Eigen::MatrixXcd left = s / T_given * Eigen::MatrixXcd::Identity(n, n) - own;
      const std::complex<double> found = (seen * left.lu().solve(by_input))(0);
      EXPECT_LE(std::abs(found - pade(n, s)), 1e-12);
    }
    // the approximant differs from e^(−s) by about s^(2 n) n! (n − 1)!/((2 n)! (2 n − 1)!)
    const double s = 0.5, rest_of_series = std::pow(s, 2 * n) * factorial(n) * factorial(n - 1) /
                                           (factorial(2 * n) * factorial(2 * n - 1));
    EXPECT_LE(std::abs(pade(n, s) - std::exp(-s)), rest_of_series + 1e-15);
  }
}

// The limit of the output, reached at a limited rate.
TEST(blocks, stay_within_limits) {
  const auto p = some_parameters();
  const kanexpr::input_values<System> far{{r, 1000}};
  kanexpr::state<System> x;
  double t = 0, before = 0;
  for (int k = 0; k < 2000; ++k) {
    ASSERT_TRUE(kanexpr::runge_kutta_4<System>{}(t, x, 1e-3, p, far));
    ASSERT_LE(std::abs(x[Valve::output] - before), 2e-3 * (1 + 1e-12));
    before = x[Valve::output];
  }
  EXPECT_NEAR(x[Valve::output], 4, 0.02); // still on its way to 5
}

TEST(dc_motor, has_a_current) {
  using namespace motors;
  using motor_eom = kanexpr::equations_of_motion<motors::System>;
  const kanexpr::parameter_values<motors::System> p{{J, 3}};
  const kanexpr::input_values<motors::System> given{{V, 12}};
  kanexpr::state<motors::System> x;
  const double u = 0.4, i = 1.7;
  x << 0.3, u, i;
  EXPECT_EQ(x[kanexpr::current_of<Wheel>], i);
  const auto rates = motor_eom::rhs(x, p, given);
  EXPECT_NEAR(rates(1), (10 * 0.1 * i - 100 * 0.02 * u) / 3, 1e-15);
  EXPECT_NEAR(rates(2), (12 - 2 * i - 0.1 * 10 * u) / 0.01, 1e-12);
}

TEST(dc_motor, is_that_of_a_builder) {
  using namespace motors;
  namespace runtime = kanexpr::runtime;
  runtime::builder b("N");
  const auto q1 = b.coordinate("q"), u1 = b.speed("u"), inertia = b.parameter("J"), voltage = b.input("V");
  b.kinematic_equation(b.dot(q1) - u1);
  const runtime::frame_id n = b.inertial_frame(), wheel = b.rotated("Wheel", n, q1, b.along(n, 0, 0, 1));
  const runtime::point_id o = b.origin("O");
  b.rigid_body("Wheel", o, wheel, b.number(1), b.inertia(wheel, inertia, inertia, inertia));
  const runtime::dc_motor_states motor =
      b.dc_motor("Wheel", u1,
                 {.voltage = voltage,
                  .resistance = 2,
                  .inductance = 0.01,
                  .torque_constant = 0.1,
                  .gear_ratio = 10,
                  .friction = 0.02,
                  .winding = runtime::dc_motor_data::winding_data{0.004, 30, 1.5}});
  b.torque_between(wheel, n, b.along(n, 0, 0, motor.torque));
  b.rotor("Rotor", q1, 0.01, 10);
  auto model = kanexpr::derive(b);
  ASSERT_EQ(model.mistake(), "");
  const Eigen::Vector4d x(0.3, 0.4, 1.7, 20);
  const Eigen::VectorXd rates = model.function(model.get(kanexpr::mechanics::quantity::rhs))(
      x, Eigen::VectorXd::Constant(1, 3), Eigen::VectorXd::Constant(1, 12));
  const Eigen::Vector4d expected = kanexpr::equations_of_motion<WarmSystem>::rhs(
      kanexpr::state<WarmSystem>(x), kanexpr::parameter_values<WarmSystem>{{J, 3}},
      kanexpr::input_values<WarmSystem>{{V, 12}});
  EXPECT_LT((rates - expected).norm(), 1e-13 * expected.norm());
}

// In a steady state, the heat of the winding flows off.
TEST(dc_motor, becomes_warm) {
  using namespace motors;
  kanexpr::state<WarmSystem> x;
  const double u = 0.4, i = 1.7, heat = 20;
  x << 0.3, u, i, heat;
  const auto rates = kanexpr::equations_of_motion<WarmSystem>::rhs(
      x, kanexpr::parameter_values<WarmSystem>{{J, 3}}, kanexpr::input_values<WarmSystem>{{V, 12}});
  const double resistance = 2 * (1 + 0.004 * heat);
  EXPECT_EQ(x[kanexpr::heating_of<Wheel>], heat);
  EXPECT_NEAR(rates(1), (10 * 0.1 * i - 100 * 0.02 * u) / (3 + 100 * 0.01),
              1e-15); // the rotor's inertia n² J
  EXPECT_NEAR(rates(2), (12 - resistance * i - 0.1 * 10 * u) / 0.01, 1e-12);
  EXPECT_NEAR(rates(3), (resistance * i * i - heat / 1.5) / 30, 1e-14);
}

} // namespace
