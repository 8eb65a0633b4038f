#include "build_recipe.hpp"
#include "newton_euler_dynamics.hpp"
#include "random_mechanism.hpp"

#include <gtest/gtest.h>

namespace {

using kanexpr::mechanics::equations;
using kanexpr::mechanics::quantity;
using recipe::builder;

constexpr double tolerance = 1e-11;

// Relative to the largest entry, or to what the entries are sums of.
void expect_equal(const Eigen::MatrixXd& found, const Eigen::MatrixXd& expected, double scale, const char* what) {
  ASSERT_EQ(found.rows(), expected.rows()) << what;
  ASSERT_EQ(found.cols(), expected.cols()) << what;
  const double size = std::max(scale, expected.cwiseAbs().maxCoeff());
  const double error = (found - expected).cwiseAbs().maxCoeff();
  EXPECT_LE(error, tolerance * size) << what << "\nfound\n" << found << "\nexpected\n" << expected;
  EXPECT_FALSE(found.hasNaN()) << what;
}

double condition(const Eigen::MatrixXd& m) {
  const Eigen::VectorXd values = m.selfadjointView<Eigen::Lower>().eigenvalues();
  return values.minCoeff() > 0 ? values.maxCoeff() / values.minCoeff() : std::numeric_limits<double>::infinity();
}

class random_mechanism : public testing::TestWithParam<unsigned> {};

TEST_P(random_mechanism, obeys_newton_and_euler) {
  recipe::mechanism m = recipe::generator(GetParam(), true).run();
  newton_euler::dynamics expected = newton_euler::evaluate(m);
  if (condition(expected.mass_matrix) > 1e9) {
    m = recipe::generator(GetParam(), false).run();
    expected = newton_euler::evaluate(m);
  }
  builder b("N");
  const recipe::building built(m, b);
  ASSERT_EQ(b.check().view(), "");
  equations derived(b.mechanism());
  const auto found = [&](quantity q) { return recipe::number(b, m, derived.get(q)); };

  expect_equal(found(quantity::qdot), expected.qdot, 1, "qdot");
  expect_equal(found(quantity::mass_matrix), expected.mass_matrix, 0, "mass matrix");
  expect_equal(found(quantity::forcing), expected.forcing, 1 + expected.force_scale, "forcing");
  expect_equal(found(quantity::active_forces), expected.active_forces, 1 + expected.force_scale, "active forces");
  expect_equal(found(quantity::kinetic_energy), Eigen::MatrixXd::Constant(1, 1, expected.kinetic_energy), 0, "kinetic energy");
  expect_equal(found(quantity::potential_energy), Eigen::MatrixXd::Constant(1, 1, expected.potential_energy), 10, "potential energy");
  expect_equal(found(quantity::linear_momentum), expected.linear_momentum, 1, "linear momentum");
  expect_equal(found(quantity::angular_momentum), expected.angular_momentum, 1, "angular momentum");
  expect_equal(found(quantity::center_of_mass), expected.center_of_mass, 1, "center of mass");
  expect_equal(found(quantity::udot), expected.udot, std::max(1., condition(expected.mass_matrix) / 1e4), "udot");
  EXPECT_EQ(derived.mistake().view(), "");
}

INSTANTIATE_TEST_SUITE_P(seeds, random_mechanism, testing::Range(0u, 20000u));

} // namespace
