// builds: clang++ all
// Random mechanisms with random constraints, compared with the Newton-Euler equations with Lagrange
// multipliers, [M −Jᵀ; J 0] [u̇; λ] = [f; −γ], in plain numbers.
#include "mechanics/random/bound_mechanism.hpp"
#include "mechanics/random/constrained_recipe.hpp"

#include <gtest/gtest.h>

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using elimination::largest;
using elimination::product;
using elimination::transposed;
using kanexpr::mechanics::quantity;
using recipe::at;
using recipe::columns_of;
using recipe::entries_of;
using recipe::speeds_of;

constexpr double tolerance = 1e-11;

// The pivots of elimination without exchanges: positive for a positive definite matrix.
double least_pivot(MatrixXd a) {
  double least = a(0, 0);
  for (Index k = 0; k < a.rows(); ++k) {
    least = std::min(least, a(k, k));
    for (Index i = k + 1; i < a.rows(); ++i) {
      const double factor = a(i, k) / a(k, k);
      for (Index j = k; j < a.cols(); ++j) a(i, j) -= factor * a(k, j);
    }
  }
  return least;
}

struct comparison : recipe::bound_mechanism {
  recipe::constrained& expected;
  double conditioning = 1; // the size of the dependent speeds relative to the independent ones

  explicit comparison(recipe::constrained& of) : bound_mechanism(of.m, of.bounds), expected(of) {}

  void run(const std::vector<int>& dependent = {}) {
    for (int u : dependent) b.dependent(built.speed(u));
    ASSERT_EQ(b.check().view(), "");
    derived.constrain();
    ASSERT_EQ(derived.mistake().view(), "");
    compare();
    ASSERT_EQ(derived.mistake().view(), "");
  }

private:
  // Relative to the largest entry, or to the terms of which the entries are sums.
  void expect_equal(const MatrixXd& value, const MatrixXd& wanted, double scale, const std::string& what) {
    ASSERT_EQ(value.rows(), wanted.rows()) << what;
    ASSERT_EQ(value.cols(), wanted.cols()) << what;
    const double size = std::max(scale, largest(wanted)), error = largest(value - wanted) / size;
    EXPECT_TRUE(error <= tolerance) << what << ": off by " << error << " times " << size;
  }

  void compare() {
    const auto &d = derived.speeds().dependent, &i = derived.speeds().independent;
    const MatrixXd &j = expected.linear.jacobian, &mass = expected.free.mass_matrix;
    expect_equal(found(quantity::constraint_jacobian), j, 1, "Jacobian");
    const MatrixXd square = columns_of(j, d),
                   inverse = elimination::solve(square, MatrixXd::Identity(d.size(), d.size())).x;
    const MatrixXd a = -product(inverse, columns_of(j, i));
    const VectorXd rest = -product(inverse, expected.linear.bias);
    conditioning = 1 + inverse.norm() * j.norm();
    expect_equal(found(quantity::dependency), a, conditioning, "dependency");
    expect_equal(found(quantity::acceleration_bias), rest, conditioning, "acceleration bias");

    MatrixXd lift = MatrixXd::Zero(mass.rows(), i.size()); // u̇ = lift u̇_i + moved
    VectorXd moved = VectorXd::Zero(mass.rows());
    for (int r = 0; r < i.size(); ++r) lift(i[r], r) = 1;
    for (int r = 0; r < d.size(); ++r) lift.row(d[r]) = a.row(r), moved(d[r]) = rest(r);
    const MatrixXd down = transposed(lift);
    const double size = lift.norm() * lift.norm() * (mass.norm() + expected.free.force_scale);
    const MatrixXd reduced = found(quantity::mass_matrix);
    expect_equal(reduced, product(down, product(mass, lift)), size, "mass matrix");
    EXPECT_EQ(reduced, transposed(reduced));
    EXPECT_GT(least_pivot(reduced), 0);
    expect_equal(found(quantity::active_forces), product(down, expected.free.active_forces), size,
                 "active forces");
    expect_equal(found(quantity::forcing), product(down, expected.free.forcing - product(mass, moved)),
                 size * (1 + moved.norm()), "forcing");
    std::vector<double> rates;
    for (Index r = 0; r < mass.rows(); ++r) rates.push_back(std::sin(static_cast<double>(7 * r + 1)));
    const VectorXd inertia =
        expected.free.inertia_bias - product(mass, VectorXd::Map(rates.data(), mass.rows()));
    expect_equal(recipe::number(m, derived.get(quantity::inertia_forces), rates), product(down, inertia),
                 size, "inertia forces");
    compare_motion();
    compare_full();
    compare_speeds();
  }

  // Compares the residuals of all equations, which no condition number amplifies, and the results themselves.
  void compare_motion() {
    const MatrixXd &j = expected.linear.jacobian, &mass = expected.free.mass_matrix;
    const VectorXd udot = found(quantity::udot), lambda = found(quantity::multipliers);
    const double accelerations = conditioning * (1 + udot.norm()), force = 1 + expected.free.force_scale +
                                                                           mass.norm() * accelerations +
                                                                           conditioning * lambda.norm();
    expect_equal(product(j, udot), -expected.linear.bias, j.norm() * accelerations,
                 "constraints on accelerations");
    expect_equal(product(mass, udot) - product(transposed(j), lambda), expected.free.forcing, force,
                 "equations of motion");
    expect_equal(udot, expected.udot, accelerations, "udot");
    expect_equal(lambda, expected.multipliers, force, "multipliers");
    // the constraints balance the work of all other forces, including inertia, if they move themselves
    const VectorXd left = expected.free.forcing - product(mass, udot), u = speeds_of(m);
    const double power = left.cwiseProduct(u).sum(),
                 given = lambda.cwiseProduct(expected.linear.remainder).sum();
    expect_equal(MatrixXd::Constant(1, 1, power), MatrixXd::Constant(1, 1, given),
                 (1 + u.norm() + expected.linear.remainder.norm()) * force, "power");
  }

  void compare_full() {
    const VectorXd qdot = found(quantity::qdot), udot = found(quantity::udot);
    VectorXd rates(qdot.size() + udot.size());
    rates << qdot, udot;
    expect_equal(found(quantity::rhs), rates, 1, "rhs");
    const MatrixXd all = found(quantity::mass_matrix_full);
    expect_equal(product(all, rates), found(quantity::forcing_full),
                 all.norm() * rates.norm() + conditioning * conditioning * expected.free.force_scale,
                 "full equations");
  }

  // The dependent speeds, computed from the others only.
  void compare_speeds() {
    const auto& d = derived.speeds().dependent;
    const VectorXd u = speeds_of(m);
    const double size = conditioning * (1 + u.norm());
    expect_equal(found(quantity::velocity_residual), VectorXd::Zero(d.size()), size, "velocity residual");
    for (int dependent : d) m.u[at(dependent)] = std::numeric_limits<double>::quiet_NaN();
    expect_equal(found(quantity::dependent_speeds), entries_of(u, d), size, "dependent speeds");
    for (int dependent : d) m.u[at(dependent)] = u(dependent) + 1;
    expect_equal(found(quantity::velocity_residual),
                 product(expected.linear.jacobian, speeds_of(m)) + expected.linear.remainder, size,
                 "residual");
    m.u.assign(u.begin(), u.end());
  }
};

// Random columns for which the constraints are well conditioned.
std::vector<int> any_dependent(const MatrixXd& j, unsigned seed) {
  dice d(seed);
  std::vector<int> columns;
  for (int c = 0; c < j.cols(); ++c) columns.push_back(c);
  for (int attempt = 0; attempt < 30; ++attempt) {
    d.shuffle(columns);
    MatrixXd square(j.rows(), j.rows());
    for (Index c = 0; c < j.rows(); ++c) square.col(c) = j.col(columns[static_cast<std::size_t>(c)]);
    if (elimination::solve(square, MatrixXd::Zero(j.rows(), 1)).least_pivot > 0.01 * largest(j))
      return {columns.begin(), columns.begin() + static_cast<std::ptrdiff_t>(j.rows())};
  }
  return {};
}

TEST(constrained, obeys_newton_euler_and_lagrange) {
  unsigned compared = 0, by_user = 0;
  for (unsigned seed = 0; compared < 300 && seed < 2000 && !HasFailure(); ++seed) {
    SCOPED_TRACE("mechanism " + std::to_string(seed));
    recipe::constrained one(seed);
    if (!one.regular) continue;
    ++compared;
    comparison chosen(one);
    chosen.run();
    const std::vector<int> given = any_dependent(one.linear.jacobian, seed);
    if (given.empty()) continue;
    comparison told(one);
    told.run(given);
    bool differs = false;
    for (int u : given) differs = differs || !chosen.derived.speeds().dependent.contains(u);
    if (differs) ++by_user;
  }
  EXPECT_EQ(compared, 300u);
  EXPECT_GT(by_user, 100u);
}

} // namespace
