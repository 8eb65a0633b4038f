// builds: clang++ all
// The benchmark of Meijaard, Papadopoulos, Ruina & Schwab (2007), computed from the nonlinear equations of
// the bicycle: the matrices of M q'' + v C1 q' + (g K0 + v² K2) q = f with q = (lean, steer), eigenvalues,
// and the range of speeds in which it is self-stable.
#include "oracles.hpp"

#include <kanexpr/symbolic.hpp>
#include <models/bicycle.hpp>

#include <Eigen/LU>
#include <boost/math/tools/toms748_solve.hpp>

#include <array>
#include <cmath>
#include <functional>
#include <random>

namespace {

namespace symbolic = kanexpr::symbolic;
using bicycle::System;
using Eigen::Matrix2d;
using Eigen::Matrix4d;
using Eigen::Vector4d;
using kanexpr::mechanics::quantity;

// Upright and straight ahead at a speed v.
class straight_ahead {
public:
  explicit straight_ahead(quantity wanted) : result_(derived_.function(derived_.get(wanted))) {
    EXPECT_EQ(derived_.mistake(), "");
  }

  Eigen::MatrixXd operator()(double v, double gravity) {
    values_["g"] = gravity;
    const auto& parameters = derived_.mechanism().parameters;
    Eigen::VectorXd p(parameters.size());
    for (int i = 0; i < parameters.size(); ++i) p(i) = values_.at(symbolic::print(parameters[i]));
    kanexpr::state<System> x;
    x[bicycle::u3] = v / values_.at("WRrad");
    x[bicycle::u6] = v / values_.at("WFrad");
    const Eigen::MatrixXd found = result_(x, p);
    EXPECT_TRUE(result_.status());
    return found;
  }

private:
  kanexpr::model derived_ = kanexpr::derive<System>();
  kanexpr::runtime::interpreted<double> result_;
  std::map<std::string, double> values_ = oracle::load("bicycle_whipple").parameters;
};

// For lean, steer and their rates.
class lean_and_steer {
public:
  Matrix4d operator()(double v, double gravity = 9.81) {
    const std::array kept{1, 2, 3, 5}; // of q1, q2, q5, u2, u3, u5
    return all_(v, gravity)(kept, kept);
  }

private:
  straight_ahead all_{quantity::state_matrix};
};

class bicycle_stability : public testing::Test {
protected:
  const oracle::bicycle benchmark = oracle::load_bicycle();
  lean_and_steer A;
};

TEST_F(bicycle_stability, linearized_equations) {
  ASSERT_EQ(benchmark.A.size(), 11u);
  for (const auto& [v, expected] : benchmark.A) EXPECT_TRUE(oracle::close(A(v), expected, 1e-12)) << v;
}

// From the benchmark's matrices, at any speed, also backwards, and any gravity.
TEST_F(bicycle_stability, depends_on_speed_and_gravity_as_in_the_benchmark) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> speed(-15, 15), gravity(-20, 20);
  const Matrix2d inverse = benchmark.M.inverse();
  for (int repeat = 0; repeat < 100; ++repeat) {
    const double v = speed(random), g = gravity(random);
    Matrix4d expected;
    expected << Matrix2d::Zero(), Matrix2d::Identity(), -inverse * (g * benchmark.K0 + v * v * benchmark.K2),
        -inverse * v * benchmark.C1;
    EXPECT_TRUE(oracle::close(A(v, g), expected, 1e-12)) << v << ", " << g;
  }
}

// A torque on the frame about the lean axis appears only in the equation of u2, and one between frame and
// fork only in that of u5. Therefore, the mass matrix is that of lean and steer, and the spin of the wheels
// does not contribute.
TEST_F(bicycle_stability, matrices_of_the_benchmark) {
  const Eigen::Matrix3d mass = straight_ahead(quantity::mass_matrix)(5, 9.81);
  const std::array spinless{0, 2}; // of u2, u3, u5
  const Matrix2d M = mass(spinless, spinless);
  EXPECT_TRUE(oracle::close(M, benchmark.M, 1e-12));
  EXPECT_LE(std::hypot(mass(0, 1), mass(2, 1)), 1e-13 * mass(1, 1));

  const Matrix2d C1 = -M * A(1, 0).bottomRightCorner<2, 2>();
  const Matrix2d K0 = -M * A(0, 1).bottomLeftCorner<2, 2>();
  const Matrix2d K2 = -M * A(1, 0).bottomLeftCorner<2, 2>();
  EXPECT_TRUE(oracle::close(C1, benchmark.C1, 1e-12));
  EXPECT_TRUE(oracle::close(K0, benchmark.K0, 1e-12));
  EXPECT_TRUE(oracle::close(K2, benchmark.K2, 1e-12));
  EXPECT_LE(A(0, 0).bottomRows<2>().norm(), 1e-12);
}

// a in det(s - A) = s⁴ + a₁ s³ + a₂ s² + a₃ s + a₄, by the Faddeev-LeVerrier algorithm.
Vector4d characteristic_polynomial(const Matrix4d& A) {
  Vector4d a;
  Matrix4d power = A;
  for (int i = 0; i < 4; ++i) {
    if (i != 0) power = A * (power + a(i - 1) * Matrix4d::Identity());
    a(i) = -power.trace() / (i + 1);
  }
  return a;
}

// The same from the roots.
Vector4d polynomial_with(const std::vector<std::complex<double>>& zeros) {
  Eigen::Vector<std::complex<double>, 5> a{{1, 0, 0, 0, 0}};
  for (const std::complex<double> zero : zeros) a.tail<4>() -= (zero * a.head<4>()).eval();
  return a.tail<4>().real();
}

// Compares coefficients, which contain the same information and are not sensitive if two eigenvalues are
// close.
TEST_F(bicycle_stability, eigenvalues) {
  ASSERT_EQ(benchmark.eigenvalues.size(), 11u);
  for (const auto& [v, expected] : benchmark.eigenvalues) {
    const Vector4d a = characteristic_polynomial(A(v)), reference = polynomial_with(expected);
    EXPECT_TRUE(oracle::close(a, reference, 1e-12)) << v; // relative to the largest: the last may cancel
  }
}

double zero_of(const std::function<double(double)>& f) {
  std::uintmax_t most_steps = 100;
  const boost::math::tools::eps_tolerance<double> closest;
  return boost::math::tools::toms748_solve(f, 1.0, 10.0, closest, most_steps).first;
}

// Routh-Hurwitz criterion: a pair of eigenvalues is imaginary, or one is zero.
TEST_F(bicycle_stability, critical_speeds) {
  const double weave = zero_of([&](double v) {
    const Vector4d a = characteristic_polynomial(A(v));
    return a(0) * a(1) * a(2) - a(2) * a(2) - a(0) * a(0) * a(3);
  });
  const double capsize = zero_of([&](double v) { return characteristic_polynomial(A(v))(3); });
  EXPECT_NEAR(weave, benchmark.weave_speed, 1e-12 * weave);
  EXPECT_NEAR(capsize, benchmark.capsize_speed, 1e-12 * capsize);
}

} // namespace
