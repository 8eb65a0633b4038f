// builds: clang++ all
// The extended Kalman filter of a cart with a pendulum.
#include "control/matrices.hpp"
#include "control/references.hpp"
#include "no_heap.hpp"

#include <kanexpr/control/ekf.hpp>

#include <models/four_bar.hpp>
#include <models/n_pendulum_cart.hpp>

#include <kanexpr/steps/assemble.hpp>

#include <Eigen/Eigenvalues>
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

// The position of the cart, the velocity of the bob along the track and the acceleration of the cart.
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

// Compares with the same filter in NumPy, which updates the covariance by P − K C P.
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

// Normally distributed numbers by the Box-Muller method, the same with every library.
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

// For a consistent filter, the squared error weighted by the inverse covariance is a sum of squares of as
// many normally distributed numbers as there are states (Bar-Shalom, Li & Kirubarajan, Estimation with
// Applications to Tracking and Navigation, 2001, section 5.4); for 50 runs, the sum is within these bounds
// with a probability of 99.9 %.
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
  EXPECT_EQ(cause(estimate.predict(0, infinite, parameters, r, of.Q)), "the step length is not finite");
  EXPECT_EQ(cause(estimate.predict(0, 0.02, parameters, r, infinite * of.Q)),
            "the covariance of the disturbance is not finite");
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
            "the covariance of the disturbance is not positive semidefinite");
  auto indefinite = of.Q;
  indefinite(0, 1) = indefinite(1, 0) = 10;
  EXPECT_EQ(cause(estimate.predict(0, 0.02, parameters, r, indefinite)),
            "the covariance of the disturbance is not positive semidefinite");
  indefinite(1, 0) = 0;
  EXPECT_EQ(cause(estimate.predict(0, 0.02, parameters, r, indefinite)),
            "the covariance of the disturbance is not symmetric");
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

// Whether no combination of states has a negative variance, up to the rounding of their variances.
template <class Covariance>
bool is_covariance(const Covariance& given) {
  const Eigen::Matrix4d P = given.template cast<double>();
  if (P != P.transpose() || (P.diagonal().array() < 0).any()) return false;
  const Eigen::Vector4d size =
      P.diagonal().unaryExpr([](double x) { return x > 0 ? 1 / std::sqrt(x) : 1.0; });
  const Eigen::Matrix4d correlation = size.asDiagonal() * P * size.asDiagonal();
  constexpr double rounding =
      40 * static_cast<double>(std::numeric_limits<typename Covariance::Scalar>::epsilon());
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d>(correlation).eigenvalues()(0) >= -rounding;
}

// Correlated states in any units, sensors up to sixteen digits more accurate than the estimate, and
// disturbances of few states: the filter accepts its own covariance, which remains positive semidefinite.
template <class T>
void keep_a_covariance() {
  normal random;
  using vector = Eigen::Vector<T, 4>;
  const auto draw = [&] { return static_cast<T>(random()); };
  const auto drawn_size = [&] { return static_cast<T>(std::pow(10, 1.5 * random())); };
  const auto semidefinite = [&](int rank) {
    Eigen::Matrix<T, 4, 4> m = Eigen::Matrix<T, 4, 4>::Zero();
    for (int k = 0; k < rank; ++k) {
      const vector column = vector::NullaryExpr(draw);
      m += drawn_size() * drawn_size() * column * column.transpose();
    }
    const vector units = vector::NullaryExpr(drawn_size);
    m = units.asDiagonal() * m * units.asDiagonal();
    return Eigen::Matrix<T, 4, 4>((m + m.transpose()) / 2);
  };
  const parameter_values<cart, T> p = parameters.template cast<T>();
  const input_values<cart, T> r(T(1));
  for (int run = 0; run < 300; ++run) {
    const auto start = semidefinite(1 + run % 4);
    basic_ekf<cart, T, q<0>, q<1>> estimate(state<cart, T>(0, T(1.5), 0, 0), start);
    for (int k = 0; k < 10; ++k) {
      const auto Q = semidefinite(1 + k % 4);
      const status predicted = estimate.predict(T(0), T(1e-3), p, r, Q);
      ASSERT_TRUE(predicted) << predicted.cause() << "\n" << estimate.P << "\n" << Q;
      ASSERT_TRUE(is_covariance(estimate.P)) << estimate.P;
      Eigen::Matrix<T, 2, 2> R = Eigen::Matrix<T, 2, 2>::Zero();
      for (int i = 0; i < 2; ++i)
        R(i, i) = estimate.P(i, i) * static_cast<T>(std::pow(10, -16 * std::abs(std::sin(run + k + i))));
      const auto before = estimate.P;
      const status updated = estimate.update(estimate.expected(p, r), p, r, R);
      if (!updated) {
        EXPECT_EQ(updated.cause(), "the covariance of the innovation is not positive definite");
        EXPECT_EQ(estimate.P, before);
      }
      ASSERT_TRUE(is_covariance(estimate.P)) << estimate.P << "\nfrom\n" << before << "\nby\n" << R;
      for (int i = 0; i < 4; ++i) EXPECT_LE(estimate.P(i, i), before(i, i) * T(1.0001));
    }
  }
}
TEST(ekf, keeps_a_covariance_whatever_is_known) {
  keep_a_covariance<double>();
  keep_a_covariance<float>();
}

// Rounded covariances are accepted; nearly parallel disturbances lead to small pivots.
TEST(ekf, tells_an_indefinite_covariance_from_a_rounded_one) {
  normal random;
  const input_values<cart> r(1.0);
  for (int run = 0; run < 1000; ++run) {
    const double aside = std::pow(10, -8 * std::abs(random())), units = std::pow(10, 3 * random());
    Eigen::Matrix<double, 4, 2> by = Eigen::Matrix<double, 4, 2>::Random();
    by.row((run + 1) % 4) = by.row(run % 4) + aside * by.row((run + 2) % 4);
    const Eigen::Vector4d in(units, 1, 1 / units, 1);
    const Eigen::Matrix4d m = in.asDiagonal() * Eigen::Matrix4d(by * by.transpose()) * in.asDiagonal();
    ekf<cart, q<0>> estimate(state<cart>(0, 1.5, 0, 0), m);
    const status predicted = estimate.predict(0, 1e-3, parameters, r, m);
    EXPECT_TRUE(predicted) << predicted.cause() << "\n" << m;
    // The variance in its smallest direction is made negative.
    const Eigen::Vector4d size = m.diagonal().cwiseSqrt();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> of(size.cwiseInverse().asDiagonal() * m *
                                                            size.cwiseInverse().asDiagonal());
    const Eigen::Vector4d least = size.cwiseProduct(of.eigenvectors().col(0));
    const auto less = [&](double part) { return Eigen::Matrix4d(m - part * least * least.transpose()); };
    estimate.P = m;
    EXPECT_EQ(estimate.predict(0, 1e-3, parameters, r, less(1e-12)).cause(),
              "the covariance of the disturbance is not positive semidefinite");
    estimate.P = less(1e-6);
    EXPECT_EQ(estimate.predict(0, 1e-3, parameters, r, m).cause(),
              "the covariance of the state is not positive semidefinite");
    EXPECT_EQ(
        estimate.update(Eigen::Matrix<double, 1, 1>(0), parameters, r, Eigen::Matrix<double, 1, 1>(1e-4))
            .cause(),
        "the covariance of the state is not positive semidefinite");
    estimate.P = less(1e-10); // as after writing to and reading from a file
    EXPECT_TRUE(estimate.predict(0, 1e-3, parameters, r, m));
  }
}

} // namespace cart

// A closed loop: the angle of the crank is estimated from a measurement of the rocker angle. The dependent
// angles follow.
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
