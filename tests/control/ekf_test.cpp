// The extended Kalman filter of a cart with a pendulum.
#include "control/matrices.hpp"
#include "control/references.hpp"
#include "no_heap.hpp"

#include <kanexpr/control/ekf.hpp>

#include <models/four_bar.hpp>
#include <models/n_pendulum_cart.hpp>

#include <kanexpr/steps/assemble.hpp>

#include <Eigen/LU>

#include <cmath>
#include <numbers>
#include <random>

namespace {

using namespace kanexpr;
using references::close;
using references::eigen;

namespace cart {

using namespace n_pendulum_cart;
using cart = System<1>;
namespace known = references::cart;

// The place of the cart, the velocity of the bob along the track and the acceleration of the cart.
template <class T>
using filter = basic_ekf<cart, T, q<0>, dot(velocity_of<P<1>>, N::x), dot(acceleration_of<P<0>>, N::x)>;

const parameter_values<cart> parameters{{m<0>, 1.5}, {m<1>, 0.4}, {l<0>, 0.8}, {g, 9.81}};

template <class T>
struct noise {
  Eigen::Matrix<T, 4, 4> Q = Eigen::Matrix<T, 4, 1>(T(1e-6), T(1e-6), T(1e-4), T(2e-4)).asDiagonal();
  Eigen::Matrix<T, 3, 3> R =
      (Eigen::Matrix<T, 3, 3>() << T(1e-4), T(5e-5), 0, T(5e-5), T(4e-4), 0, 0, 0, T(1e-2)).finished();
  Eigen::Matrix<T, 4, 4> P = Eigen::Matrix<T, 4, 1>(T(1e-2), T(2e-2), T(4e-2), T(3e-2)).asDiagonal();
};

// Beside the same filter in NumPy, which updates by P − K C P.
template <class T>
filter<T> run_of_references() {
  const noise<T> of;
  filter<T> estimate(state<cart, T>(0, T(1.5), 0, 0), of.P);
  const parameter_values<cart, T> p = parameters.template cast<T>();
  const T h = T(0.02);
  no_heap::guard guard;
  for (int k = 0; k < 40; ++k) {
    const input_values<cart, T> r(static_cast<T>(known::forces[k]));
    const status predicted = estimate.predict(static_cast<T>(k) * h, h, p, r, of.Q);
    EXPECT_TRUE(predicted) << predicted.cause();
    const Eigen::Matrix<T, 3, 1> y = Eigen::Map<const Eigen::Vector3d>(known::seen[k]).template cast<T>();
    const status updated = estimate.update(y, p, r, of.R);
    EXPECT_TRUE(updated) << updated.cause();
  }
  return estimate;
}

TEST(ekf, is_the_filter_of_the_textbook) {
  const filter<double> found = run_of_references<double>();
  EXPECT_TRUE(close(found.x, Eigen::Map<const Eigen::Vector4d>(known::filtered_state), 1e-12));
  EXPECT_TRUE(close(found.P, eigen(known::filtered_covariance), 1e-11));
  EXPECT_EQ(found.P, found.P.transpose());
  EXPECT_TRUE(close(found.innovation(), Eigen::Map<const Eigen::Vector3d>(known::last_innovation), 1e-10));
  EXPECT_TRUE(close(found.innovation_covariance(), eigen(known::last_innovation_covariance), 1e-11));
  EXPECT_NEAR(found.t, 0.8, 1e-15);
}

TEST(ekf, works_in_single_precision) {
  const filter<float> found = run_of_references<float>();
  EXPECT_TRUE(close(found.x.cast<double>(), Eigen::Map<const Eigen::Vector4d>(known::filtered_state), 1e-4));
  EXPECT_TRUE(close(found.P.cast<double>(), eigen(known::filtered_covariance), 1e-3));
}

// Normal numbers by Box and Muller, the same with every library.
class normal {
public:
  double operator()() {
    const double u = 1 - uniform_(random_), v = uniform_(random_);
    return std::sqrt(-2 * std::log(u)) * std::cos(2 * std::numbers::pi * v);
  }
  template <int n>
  Eigen::Vector<double, n> with(const Eigen::Matrix<double, n, n>& deviations) {
    Eigen::Vector<double, n> each;
    for (double& entry : each) entry = (*this)();
    return deviations * each;
  }

private:
  std::mt19937_64 random_{20};
  std::uniform_real_distribution<double> uniform_{0, 1};
};

// Of a right filter the error squared by the inverse of its covariance is the sum of the squares of as many
// normal numbers as there are states (Bar-Shalom, Li & Kirubarajan, Estimation with Applications to Tracking
// and Navigation, 2001, section 5.4); of 50 runs it is in these bounds in 99.9 % of all cases.
TEST(ekf, knows_how_uncertain_it_is) {
  constexpr int runs = 50, steps = 60;
  constexpr double h = 0.02;
  const noise<double> of;
  const Eigen::Matrix4d disturbance = of.Q.cwiseSqrt(), start = of.P.cwiseSqrt() * 0.3;
  const Eigen::Vector2d sensors(1e-2, 2e-2);
  const Eigen::Matrix2d R = sensors.cwiseAbs2().asDiagonal();
  normal random;
  double at_half = 0, at_end = 0, of_innovations = 0;
  for (int run = 0; run < runs; ++run) {
    state<cart> truth(0, 1.4, 0, 0);
    ekf<cart, q<0>, dot(velocity_of<P<1>>, N::x)> estimate(truth + random.with<4>(start), start * start);
    double t = 0;
    for (int k = 1; k <= steps; ++k) {
      const input_values<cart> r(2 * std::sin(0.2 * k) + 0.5);
      ASSERT_TRUE(estimate.predict(t, h, parameters, r, of.Q));
      ASSERT_TRUE(runge_kutta_4<cart>{}(t, truth, h, parameters, r));
      truth += random.with<4>(disturbance);
      const Eigen::Vector2d exact(truth[q<0>], truth[u<0>] - 0.8 * std::sin(truth[q<1>]) * truth[u<1>]);
      ASSERT_TRUE(
          estimate.update(exact + random.with<2>(sensors.asDiagonal().toDenseMatrix()), parameters, r, R));
      const Eigen::Vector4d error = truth - estimate.x;
      const double squared = error.dot(estimate.P.inverse() * error);
      if (k == steps / 2) at_half += squared;
      if (k == steps) at_end += squared;
      if (k <= 4)
        of_innovations +=
            estimate.innovation().dot(estimate.innovation_covariance().inverse() * estimate.innovation());
    }
  }
  const auto is_between = [](double sum, const double(&bounds)[2]) {
    EXPECT_GT(sum, bounds[0]);
    EXPECT_LT(sum, bounds[1]);
  };
  is_between(at_half, references::chi_squared_200);
  is_between(at_end, references::chi_squared_200);
  is_between(of_innovations, references::chi_squared_400);
}

TEST(ekf, stays_as_it_was_where_it_cannot_go_on) {
  const noise<double> of;
  filter<double> estimate(state<cart>(0, 1.5, 0, 0), of.P);
  const filter<double> before = estimate;
  const input_values<cart> r(1.0);
  const double infinite = std::numeric_limits<double>::infinity();
  const auto unchanged = [&] {
    return estimate.x == before.x && estimate.P == before.P && estimate.t == before.t;
  };
  const auto cause = [&](const status& s) {
    EXPECT_FALSE(s);
    EXPECT_TRUE(unchanged());
    return s.cause();
  };
  EXPECT_EQ(cause(estimate.predict(0, 0.02, parameter_values<cart>(), r, of.Q)), "m0 has no finite value");
  EXPECT_EQ(cause(estimate.predict(0, infinite, parameters, r, of.Q)),
            "the length of the step is not finite");
  EXPECT_EQ(cause(estimate.predict(0, 0.02, parameters, r, infinite * of.Q)),
            "the covariance of what disturbs the states is not finite");
  const Eigen::Vector3d y(0, 0, 0);
  EXPECT_EQ(cause(estimate.update(infinite * Eigen::Vector3d::Ones(), parameters, r, of.R)),
            "a measurement is not finite");
  EXPECT_EQ(cause(estimate.update(y, parameters, input_values<cart>(), of.R)), "F has no finite value");
  EXPECT_EQ(cause(estimate.update(y, parameters, r, infinite * of.R)),
            "the covariance of the noise is not finite");
  EXPECT_EQ(cause(estimate.update(y, parameters, r, -1e4 * of.R)),
            "the covariance of the noise is not positive semidefinite");
  auto too_alike = of.R;
  too_alike(0, 1) = too_alike(1, 0) = 1e4;
  EXPECT_EQ(cause(estimate.update(y, parameters, r, too_alike)),
            "the covariance of the noise is not positive semidefinite");
  auto crooked = of.R;
  crooked(0, 1) = 1e-3;
  EXPECT_EQ(cause(estimate.update(y, parameters, r, crooked)),
            "the covariance of the noise is not symmetric");
  EXPECT_EQ(cause(estimate.predict(0, 0.02, parameters, r, -of.Q)),
            "the covariance of what disturbs the states is not positive semidefinite");
  auto indefinite = of.Q;
  indefinite(0, 1) = indefinite(1, 0) = 10;
  EXPECT_EQ(cause(estimate.predict(0, 0.02, parameters, r, indefinite)),
            "the covariance of what disturbs the states is not positive semidefinite");
  indefinite(1, 0) = 0;
  EXPECT_EQ(cause(estimate.predict(0, 0.02, parameters, r, indefinite)),
            "the covariance of what disturbs the states is not symmetric");
  EXPECT_TRUE(estimate.expected(parameters, r).status);
  EXPECT_EQ(estimate.expected(parameters, r)(0), 0);
  filter<double> impossible(before.x, -of.P);
  EXPECT_EQ(impossible.predict(0, 0.02, parameters, r, of.Q).cause(),
            "the covariance of the state is not positive semidefinite");
  impossible.P = of.P;
  impossible.P(0, 1) = impossible.P(1, 0) = 10;
  EXPECT_EQ(impossible.update(y, parameters, r, of.R).cause(),
            "the covariance of the state is not positive semidefinite");
  impossible.P(1, 0) = 0;
  EXPECT_EQ(impossible.update(y, parameters, r, of.R).cause(),
            "the covariance of the state is not symmetric");
  impossible.P(0, 1) = infinite;
  EXPECT_EQ(impossible.predict(0, 0.02, parameters, r, of.Q).cause(),
            "the covariance of the state is not finite");
}

} // namespace cart

// A closed loop: the angle of the crank that is measured by that of the rocker. The dependent angles follow.
TEST(ekf, keeps_the_constraints) {
  using namespace four_bar;
  using eom = equations_of_motion<System>;
  const eom::parameters p{{l0, 2}, {l1, 1}, {l2, 2},   {l3, 1.5}, {d1, 0.5}, {d2, 1},   {d3, 0.75},
                          {m1, 1}, {m2, 2}, {m3, 1.5}, {I1, 0.1}, {I2, 0.7}, {I3, 0.3}, {g, 9.81}};
  const eom::inputs r(0.0);
  eom::state truth{{q1, -2.27}, {q2, 3}, {q3, -1.5}, {u1, -1.96}, {u2, 0}, {u3, 0}};
  ASSERT_TRUE(assemble<System>(truth, p, r));
  eom::state guessed = truth;
  guessed[q1] += 0.05, guessed[u1] -= 0.1;
  ASSERT_TRUE(assemble<System>(guessed, p, r));
  ekf<System, q3> estimate(guessed, Eigen::Vector2d(1e-2, 1e-2).asDiagonal());
  static_assert(estimate.states == 2 && estimate.measurements == 1);
  const Eigen::Matrix2d Q = 1e-10 * Eigen::Matrix2d::Identity();
  const Eigen::Matrix<double, 1, 1> R(1e-8);
  double t = 0;
  for (int k = 0; k < 50; ++k) {
    ASSERT_TRUE(estimate.predict(t, 0.01, p, r, Q));
    ASSERT_TRUE(runge_kutta_4<System>{}(t, truth, 0.01, p, r));
    const status updated = estimate.update(Eigen::Matrix<double, 1, 1>(truth[q3]), p, r, R);
    ASSERT_TRUE(updated) << updated.cause();
    EXPECT_LE(eom::configuration_residual(estimate.x, p).norm(), k < 5 ? 1e-4 : 1e-9);
    EXPECT_LE(eom::velocity_residual(estimate.x, p).norm(), 1e-12);
  }
  EXPECT_LE((estimate.x - truth).norm(), 1e-3);
}

} // namespace
