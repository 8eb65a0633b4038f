// builds: clang++
// Linearizations of systems without constraints, compared with the oracles and with complex steps at random
// operating points, most of which are not equilibria.
#include "systems/linearized.hpp"

#include <models/arm3.hpp>
#include <models/double_pendulum.hpp>
#include <models/n_pendulum_cart.hpp>
#include <models/pivot_body.hpp>
#include <models/rocket.hpp>
#include <models/rolling_disc.hpp>
#include <models/rolling_torus.hpp>
#include <models/rotating_tube.hpp>
#include <models/simple_pendulum.hpp>
#include <models/spinning_top.hpp>

#include <Eigen/Eigenvalues>

namespace {

using check::linearization_agrees;
using check::VectorXd;

TEST(linearization, simple_pendulum) {
  linearization_agrees<simple_pendulum::System>("simple_pendulum", VectorXd::Zero(2), 3);
}
TEST(linearization, double_pendulum) {
  linearization_agrees<double_pendulum::System>("double_pendulum", VectorXd::Zero(4), 3);
}
TEST(linearization, n_pendulum_cart) {
  linearization_agrees<n_pendulum_cart::System<5>>("npendulum_cart_n5", VectorXd::Zero(12), 3);
}
TEST(linearization, rolling_disc) {
  linearization_agrees<rolling_disc::System>("rolling_disc", VectorXd::Zero(6), 1.2);
}
TEST(linearization, rolling_torus) {
  linearization_agrees<rolling_torus::System>("rolling_torus", VectorXd::Zero(6), 1.2);
}
TEST(linearization, rotating_tube) {
  linearization_agrees<rotating_tube::System>("rotating_tube", VectorXd::Zero(2), 3);
}
TEST(linearization, rocket) {
  linearization_agrees<rocket::System>("rocket_variable_mass", VectorXd::Zero(2), 3);
}
TEST(linearization, arm3) { linearization_agrees<arm3::System>("arm3_spatial", VectorXd::Zero(6), 1.2); }
TEST(linearization, spinning_top) {
  linearization_agrees<spinning_top::System>("spinning_top", VectorXd{{0, 1, 0, 0, 0, 0}}, 0.7);
}
TEST(linearization, pivot_body) {
  check::linearize<pivot_body::System>().against_complex_steps("quaternion_pivot_body",
                                                               VectorXd{{0.5, 0.5, -0.5, 0.5, 0, 0, 0}}, 0.3);
}

// A disc that rolls straight is neither stable nor unstable at the speed at which all eigenvalues vanish.
TEST(linearization, disc_at_its_critical_spin) {
  check::linearized disc = check::linearize<rolling_disc::System>();
  const auto eigenvalues = [&](double spin) {
    const VectorXd x{{0, 0, 0, 0, spin, 0}}, p = VectorXd::Ones(3);
    return Eigen::VectorXcd(disc.at(0, x, p, VectorXd()).A.eigenvalues());
  };
  const double critical = 1 / std::sqrt(3.0);
  // a double root: a rounding error of 1e-16 may move it by the square root of that
  EXPECT_LE(eigenvalues(critical).cwiseAbs().maxCoeff(), 1e-7);
  EXPECT_GT(eigenvalues(0.9 * critical).real().maxCoeff(), 0.3);
  EXPECT_LE(eigenvalues(1.1 * critical).real().maxCoeff(), 1e-7);
}

} // namespace
