// builds: clang++ all
// The regressor, compared with inverse dynamics, which treats masses and inertias differently, at random
// states that violate the constraints, and with a textbook; compiled and run-time results agree to the last
// bit. Base parameters, compared with counts and formulas of the literature and with inverse dynamics.
#include "runtime/agreement.hpp"

#include <kanexpr/runtime/base_parameters.hpp>

#include <models/double_pendulum.hpp>
#include <models/four_bar.hpp>
#include <models/iiwa.hpp>
#include <models/puma.hpp>
#include <models/rolling_disc_constrained.hpp>

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using kanexpr::mechanics::quantity;

VectorXd random_numbers(std::mt19937_64& source, Index count, double from, double to) {
  std::uniform_real_distribution<double> unit(from, to);
  return VectorXd::NullaryExpr(count, [&] { return unit(source); });
}

struct linear_dynamics {
  kanexpr::model m;
  kanexpr::runtime::interpreted<double> y = m.function(m.get(quantity::regressor));
  kanexpr::runtime::interpreted<double> remainder = m.function(m.get(quantity::load_compensation));
  kanexpr::runtime::interpreted<double> values = m.function(m.get(quantity::inertial_parameters));
  kanexpr::runtime::interpreted<double> inverse = m.function(m.get(quantity::inverse_dynamics));
  Index states = m.mechanism().coordinates.size() + m.mechanism().speeds.size(),
        speeds = m.mechanism().speeds.size(), inputs = m.mechanism().inputs.size(),
        parameters = m.mechanism().parameters.size();

  explicit linear_dynamics(kanexpr::model of) : m(std::move(of)) {}

  /// A random state with given parameters.
  template <class Values>
  void expect_linear(const VectorXd& p, std::mt19937_64& source, const Values& values_of) {
    const double t = random_numbers(source, 1, -1, 1)(0);
    const VectorXd x = random_numbers(source, states, -2, 2), r = random_numbers(source, inputs, -2, 2),
                   a = random_numbers(source, speeds, -2, 2);
    const MatrixXd by_parameters = y(t, x, p, r, a);
    const VectorXd pi = values_of(t, x), forces = inverse(t, x, p, r, a);
    ASSERT_EQ(by_parameters.cols(), pi.size());
    const VectorXd rest = remainder(t, x, p, r);
    ASSERT_TRUE(y.status()) << y.status().cause();
    const double scale = (by_parameters.cwiseAbs() * pi.cwiseAbs() + rest.cwiseAbs()).maxCoeff();
    EXPECT_LE((by_parameters * pi + rest - forces).cwiseAbs().maxCoeff(), 1e-12 * scale);
  }
};

void expect_linear(kanexpr::model of) {
  linear_dynamics linear(std::move(of));
  ASSERT_EQ(linear.m.mistake(), "");
  ASSERT_EQ(static_cast<Index>(linear.m.names_of_inertial_parameters().size()),
            linear.values(VectorXd::Zero(linear.states), VectorXd::Ones(linear.parameters)).rows());
  std::mt19937_64 source(31);
  for (int round = 0; round < 20; ++round) {
    const VectorXd p = random_numbers(source, linear.parameters, 0.5, 2);
    linear.expect_linear(p, source,
                         [&](double t, const VectorXd& x) { return linear.values(t, x, p, VectorXd()); });
  }
}

TEST(regressor, by_lagrange) { expect_linear(kanexpr::derive<double_pendulum::LagrangeSystem>()); }
TEST(regressor, iiwa) { expect_linear(kanexpr::derive<iiwa::System>()); }
TEST(regressor, four_bar) { expect_linear(kanexpr::derive<four_bar::System>()); }
TEST(regressor, rolling_disc) { expect_linear(kanexpr::derive<rolling_disc_constrained::System>()); }

/// A body that rotates about two axes and carries a second one, which slides and rotates, and a particle; all
/// their properties are parameters.
namespace chain {

using namespace kanexpr;

template <int i>
constexpr coordinate<"q", i> q;
template <int i>
constexpr speed<"u", i> u;
template <int i>
constexpr parameter<"m", i> m;
template <int i, int axis>
constexpr parameter<"c", 10 * i + axis> c;
template <int i, int entry>
constexpr parameter<"i", 10 * i + entry> moment;
constexpr parameter<"l"> l;
constexpr parameter<"k"> k;

struct N : inertial_frame<N> {};
struct O : origin<O, N> {};
struct Turned : rotated<Turned, N, q<1>, N::z> {};
struct A : rotated<A, Turned, q<2>, Turned::y> {};
struct B : rotated<B, A, q<4>, A::x> {};

struct Ac : offset<Ac, O, c<1, 1> * A::x + c<1, 2> * A::y + c<1, 3> * A::z> {};
struct J : offset<J, O, l * A::x + q<3> * A::y> {};
struct Bm : offset<Bm, J, c<2, 1> * B::x> {};
struct Bc : offset<Bc, Bm, c<2, 2> * B::y + c<2, 3> * B::z> {};
struct Pc : offset<Pc, Bc, l * B::y> {};

template <class Frame, int i>
using moments =
    inertia<Frame, moment<i, 1>, moment<i, 2>, moment<i, 3>, moment<i, 4>, moment<i, 5>, moment<i, 6>>;
struct Upper : rigid_body<Upper, Ac, A, m<1>, effective_inertia<moments<A, 1>>> {};
struct Lower : rigid_body<Lower, Bc, B, m<2>, effective_inertia<moments<B, 2>>> {};
struct Bob : particle<Bob, Pc, m<3>> {};

struct System
    : kane_system<
          inertial<N>, coordinates<q<1>, q<2>, q<3>, q<4>>, speeds<u<1>, u<2>, u<3>, u<4>>,
          kinematics<dot(q<1>) == u<1>, dot(q<2>) == u<2>, dot(q<3>) == u<3>, dot(q<4>) == u<4>>,
          parameters<l, k, m<1>, c<1, 1>, c<1, 2>, c<1, 3>, moment<1, 1>, moment<1, 2>, moment<1, 3>,
                     moment<1, 4>, moment<1, 5>, moment<1, 6>, m<2>, c<2, 1>, c<2, 2>, c<2, 3>, moment<2, 1>,
                     moment<2, 2>, moment<2, 3>, moment<2, 4>, moment<2, 5>, moment<2, 6>, m<3>>,
          bodies<Upper, Lower, Bob>, loads<gravity<-9.81 * N::z>, force<Bc, -k * m<2> * velocity_of<Bc>>>> {};

} // namespace chain

/// The parallel-axis theorem, written by hand for ten numbers that start with the mass and the mass center.
VectorXd about_joint(const VectorXd& given) {
  const double mass = given(0);
  const Vector3d center = given.segment<3>(1);
  const Eigen::Matrix3d added =
      mass * (center.squaredNorm() * Eigen::Matrix3d::Identity() - center * center.transpose());
  VectorXd pi(10);
  pi << mass, mass * center, given(4) + added(0, 0), given(5) + added(1, 1), given(6) + added(2, 2),
      given(7) + added(0, 1), given(8) + added(1, 2), given(9) + added(2, 0);
  return pi;
}

// There are more sets of parameters than columns, so every column is correct.
TEST(regressor, columns) {
  linear_dynamics linear(kanexpr::derive<chain::System>());
  ASSERT_EQ(linear.m.mistake(), "");
  std::mt19937_64 source(37);
  for (int round = 0; round < 60; ++round) {
    const VectorXd p = random_numbers(source, linear.parameters, -2, 2);
    VectorXd pi(21);
    pi << about_joint(p.segment(2, 10)), about_joint(p.segment(12, 10)), p(22);
    linear.expect_linear(p, source, [&](double, const VectorXd&) { return pi; });
    const VectorXd values = linear.values(VectorXd::Zero(8), p);
    EXPECT_LE((values - pi).cwiseAbs().maxCoeff(), 1e-12 * pi.cwiseAbs().maxCoeff());
  }
  const std::vector<std::string> names = linear.m.names_of_inertial_parameters();
  EXPECT_EQ(names[0], "m of Upper");
  EXPECT_EQ(names[11], "m*x of Lower");
  EXPECT_EQ(names[19], "izx of Lower");
  EXPECT_EQ(names[20], "m of Bob");
}

// Spong, Hutchinson & Vidyasagar, Robot Modeling and Control (2006), example 7.4, with first moments and
// moments of inertia about the joints.
TEST(regressor, of_two_bars_by_hand) {
  using system = double_pendulum::LagrangeSystem;
  using compiled = kanexpr::regressor<system>;
  static_assert(compiled::size == 20);
  EXPECT_EQ(compiled::names[16].view(), "izz of Bar2");
  std::mt19937_64 source(41);
  for (int round = 0; round < 20; ++round) {
    const VectorXd state = random_numbers(source, 4, -3, 3), p = random_numbers(source, 10, 0.5, 2),
                   a = random_numbers(source, 2, -3, 3);
    const kanexpr::state<system> x = state;
    const MatrixXd y = compiled::matrix(x, kanexpr::parameter_values<system>(p), Eigen::Vector2d::Zero(),
                                        Eigen::Vector2d(a));
    const double q1 = x(0), q2 = x(1), w1 = x(2), w2 = x(3), a1 = a(0), a2 = a(1), l = p(4), g = p(7);
    const double co = std::cos(q2), si = std::sin(q2), all = w1 + w2;
    MatrixXd expected = MatrixXd::Zero(2, 20);
    expected(0, 1) = g * std::cos(q1), expected(0, 2) = -g * std::sin(q1), expected(0, 6) = a1;
    expected(0, 10) = l * l * a1 + l * g * std::cos(q1);
    expected(0, 11) = l * (co * (2 * a1 + a2) - si * (all * all - w1 * w1)) + g * std::cos(q1 + q2);
    expected(0, 12) = -l * (si * (2 * a1 + a2) + co * (all * all - w1 * w1)) - g * std::sin(q1 + q2);
    expected(0, 16) = expected(1, 16) = a1 + a2;
    expected(1, 11) = l * (co * a1 + si * w1 * w1) + g * std::cos(q1 + q2);
    expected(1, 12) = l * (-si * a1 + co * w1 * w1) - g * std::sin(q1 + q2);
    EXPECT_LE((y - expected).cwiseAbs().maxCoeff(), 1e-12 * expected.cwiseAbs().maxCoeff());
  }
}

TEST(regressor, is_the_same_in_the_compiler) {
  using system = double_pendulum::LagrangeSystem;
  using compiled = kanexpr::regressor<system>;
  std::mt19937_64 source(3);
  const auto x = agreement::random<kanexpr::state<system>>(source, -3, 3);
  const auto p = agreement::random<kanexpr::parameter_values<system>>(source, 0.5, 2);
  const auto r = agreement::random<kanexpr::input_values<system>>(source, -5, 5);
  const Eigen::Vector2d a(0.3, -0.7);
  const auto each = [](quantity wanted) {
    auto m = kanexpr::derive<system>();
    return m.function(m.get(wanted));
  };
  agreement::expect_same_bits(compiled::matrix(x, p, r, a), each(quantity::regressor)(0, x, p, r, a));
  agreement::expect_same_bits(compiled::remainder(x, p, r), each(quantity::load_compensation)(0, x, p, r));
  agreement::expect_same_bits(compiled::parameters(x, p), each(quantity::inertial_parameters)(x, p));
}

namespace chain {

constexpr time_variable t;
struct Leaking : particle<Leaking, Ac, m<1> * (2 - t)> {};
struct LeakingSystem : kane_system<inertial<N>, coordinates<q<1>, q<2>>, speeds<u<1>, u<2>>,
                                   kinematics<dot(q<1>) == u<1>, dot(q<2>) == u<2>>,
                                   parameters<m<1>, c<1, 1>, c<1, 2>, c<1, 3>>, bodies<Leaking>> {};

} // namespace chain

TEST(regressor, is_of_masses_that_stay) {
  auto m = kanexpr::derive<chain::LeakingSystem>();
  constexpr const char* expected =
      "the regressor requires constant masses and inertias; those of Leaking change";
  EXPECT_EQ(m.get(quantity::regressor).entries.size(), 0);
  EXPECT_EQ(m.mistake(), expected);
  EXPECT_EQ(kanexpr::find_base_parameters(m, VectorXd::Ones(4)).cause(), expected);
}

/// Y π for any π, at states other than those from which the parameters were found.
void expect_same_forces(kanexpr::model& m, const kanexpr::base_parameters& base, const VectorXd& p) {
  auto regressor = m.function(m.get(quantity::regressor)), udot = m.function(m.get(quantity::udot));
  std::mt19937_64 source(101);
  const Index states = m.mechanism().coordinates.size() + m.mechanism().speeds.size();
  int compared = 0;
  for (int round = 0; round < 20; ++round) {
    VectorXd x = random_numbers(source, states, -3, 3);
    const VectorXd r = random_numbers(source, m.mechanism().inputs.size(), -9, 9);
    if (!kanexpr::assemble(m, x, p, r)) continue;
    const VectorXd a = udot(0, x, p, r);
    const MatrixXd y = regressor(0, x, p, r, a);
    const VectorXd pi = random_numbers(source, y.cols(), -1, 1);
    EXPECT_LE((y * pi - base.columns_of(y) * (base.combination * pi)).cwiseAbs().maxCoeff(),
              1e-10 * (y.cwiseAbs() * pi.cwiseAbs()).maxCoeff());
    ++compared;
  }
  EXPECT_GE(compared, 10);
}

void expect_count(kanexpr::model m, std::size_t count, const VectorXd& p = {}) {
  const kanexpr::base_parameters base = kanexpr::find_base_parameters(m, p);
  ASSERT_TRUE(base) << base.cause();
  EXPECT_EQ(base.names.size(), count);
  expect_same_forces(m, base, p);
}

// Mayeda, Yoshida & Osuka, Base Parameters of Manipulator Dynamic Models (1990): 7 n − 4 β − 2 for n revolute
// joints, the first of which is vertical and parallel to the next β − 1.
TEST(base_parameters, puma) { expect_count(kanexpr::derive<puma::System>(), 36); }
TEST(base_parameters, iiwa) { expect_count(kanexpr::derive<iiwa::System>(), 43); }
// Three bars in a row have nine; a particle at the last bearing needs no force.
TEST(base_parameters, four_bar) {
  auto m = kanexpr::derive<four_bar::System>();
  expect_count(m, 8, VectorXd::LinSpaced(m.mechanism().parameters.size(), 1, 1.6));
}

TEST(base_parameters, of_two_bars) {
  auto m = kanexpr::derive<double_pendulum::LagrangeSystem>();
  VectorXd p = VectorXd::Ones(10);
  p(4) = 0.5; // l1
  const kanexpr::base_parameters base = kanexpr::find_base_parameters(m, p);
  ASSERT_TRUE(base) << base.cause();
  EXPECT_EQ(base.names, (std::vector<std::string>{"m*x of Bar1 + 0.5*m of Bar2", "m*y of Bar1",
                                                  "izz of Bar1 + 0.25*m of Bar2", "m*x of Bar2",
                                                  "m*y of Bar2", "izz of Bar2"}));
  expect_same_forces(m, base, p);
  p(7) = 0; // g
  EXPECT_EQ(kanexpr::find_base_parameters(m, p).names,
            (std::vector<std::string>{"izz of Bar1 + 0.25*m of Bar2", "m*x of Bar2", "m*y of Bar2",
                                      "izz of Bar2"}));
}

TEST(base_parameters, need_the_parameters_of_the_model) {
  auto m = kanexpr::derive<double_pendulum::LagrangeSystem>();
  EXPECT_EQ(kanexpr::find_base_parameters(m).cause(), "base parameters: got 0 parameters, expected 10");
  EXPECT_EQ(kanexpr::find_base_parameters(m, VectorXd::Ones(10), {.tolerance = 0.01}).cause(),
            "dependent and independent inertial parameters cannot be separated with a tolerance of 0.01");
  VectorXd p = VectorXd::Ones(10);
  p(4) = 1e6; // a length in micrometers
  EXPECT_EQ(kanexpr::find_base_parameters(m, p).cause(),
            "dependent and independent inertial parameters cannot be separated with a tolerance of 1e-09");
  p(4) = std::numeric_limits<double>::infinity();
  EXPECT_THAT(kanexpr::find_base_parameters(m, p).cause(), testing::EndsWith(" is not finite"));
  EXPECT_EQ(kanexpr::find_base_parameters(m, VectorXd::Ones(11)).cause(),
            "base parameters: got 11 parameters, expected 10");
  EXPECT_EQ(kanexpr::find_base_parameters(m, VectorXd::Ones(10), {.tolerance = 2}).cause(),
            "the tolerance of base parameters must be between 0 and 1, got 2");
}

} // namespace
