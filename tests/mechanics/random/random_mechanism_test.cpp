// builds: clang++
#include "build_recipe.hpp"
#include "newton_euler_dynamics.hpp"
#include "random_mechanism.hpp"
#include "random_springs.hpp"

#include <gtest/gtest.h>
#include <kanexpr/mechanics/dynamics/articulated_bodies.hpp>
#include <kanexpr/mechanics/motion/observe.hpp>

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using kanexpr::mechanics::equations;
using kanexpr::mechanics::quantity;
using recipe::builder;

constexpr double tolerance = 1e-11;

// Relative to the largest entry, or to the terms of which the entries are sums.
void expect_equal(const MatrixXd& found, const MatrixXd& expected, double scale, const std::string& what) {
  ASSERT_EQ(found.rows(), expected.rows()) << what;
  ASSERT_EQ(found.cols(), expected.cols()) << what;
  const MatrixXd difference = found - expected;
  double error = 0, size = scale;
  bool numbers = true;
  for (Eigen::Index i = 0; i < found.size(); ++i) {
    error = std::max(error, std::abs(difference.data()[i]));
    size = std::max(size, std::abs(expected.data()[i]));
    numbers = numbers && difference.data()[i] == difference.data()[i];
  }
  EXPECT_TRUE(numbers && error <= tolerance * size) << what << ": off by " << error << " of " << size;
}

// Whether the equations can be solved for u̇: if a declared velocity removes all mass from a speed, there is
// no mechanism.
bool solvable(const MatrixXd& mass_matrix) {
  MatrixXd left = mass_matrix;
  double least = 1e300, most = 0;
  for (Eigen::Index k = 0; k < left.rows(); ++k) {
    least = std::min(least, left(k, k)), most = std::max(most, left(k, k));
    for (Eigen::Index i = k + 1; i < left.rows(); ++i) {
      const double factor = left(i, k) / left(k, k);
      for (Eigen::Index j = k; j < left.cols(); ++j) left(i, j) -= factor * left(k, j);
    }
  }
  return least > 1e-8 * most;
}

struct comparison {
  recipe::mechanism m;
  newton_euler::dynamics expected;
  builder b{"N"};
  bool regular = true;

  explicit comparison(unsigned seed)
      : m(recipe::generator(seed, true).run()), expected(newton_euler::evaluate(m)) {
    if (!solvable(expected.mass_matrix)) m = recipe::generator(seed, false).run();
    recipe::random_springs(m, seed).hang();
    expected = newton_euler::evaluate(m);
    regular = solvable(expected.mass_matrix);
  }

  void run() {
    const recipe::building built(m, b);
    ASSERT_EQ(b.check().view(), "");
    equations derived(b.system());
    compare_dynamics(derived);
    compare_motion(derived, built);
  }

  void compare_dynamics(equations& derived) {
    const auto found = [&](quantity q) { return recipe::number(m, derived.get(q)); };
    const auto scalar = [](double x) { return MatrixXd::Constant(1, 1, x); };
    const double force = 1 + expected.force_scale;
    expect_equal(found(quantity::qdot), expected.qdot, 1, "qdot");
    expect_equal(found(quantity::mass_matrix), expected.mass_matrix, 1, "mass matrix");
    expect_equal(found(quantity::forcing), expected.forcing, force, "forcing");
    expect_equal(found(quantity::active_forces), expected.active_forces, force, "active forces");
    expect_equal(found(quantity::kinetic_energy), scalar(expected.kinetic_energy), 1, "kinetic energy");
    if (m.has_gravity || !m.springs.empty() || !m.twists.empty())
      expect_equal(found(quantity::potential_energy), scalar(expected.potential_energy), 10,
                   "potential energy");
    expect_equal(found(quantity::linear_momentum), expected.linear_momentum, 1, "linear momentum");
    expect_equal(found(quantity::angular_momentum), expected.angular_momentum, 1, "angular momentum");
    expect_equal(found(quantity::center_of_mass), expected.center_of_mass, 1, "center of mass");
    if (!regular) return;
    const auto expect_solution = [&](const VectorXd& udot, const std::string& what) {
      // by the residual, which no condition number amplifies
      expect_equal(newton_euler::times(expected.mass_matrix, udot), expected.forcing,
                   force + expected.mass_matrix.diagonal().maxCoeff() * udot.norm(), what);
    };
    expect_solution(found(quantity::udot), "udot");
    expect_solution(recipe::number(m, by_articulated_bodies(derived)), "udot by articulated bodies");
    const int variant = static_cast<int>(m.frames.size() + m.points.size()) % 4; // one of the forms
    expect_solution(recipe::number(m, in_other_form(variant)), "udot in form " + std::to_string(variant));
    EXPECT_EQ(derived.mistake().view(), "");
  }

  static kanexpr::symbolic::matrix by_articulated_bodies(equations& derived) {
    kanexpr::symbolic::matrix f = derived.get(quantity::forcing);
    f.entries = kanexpr::mechanics::articulated_bodies(derived.skeleton_used()).solve(f.entries).x;
    return f;
  }

  // With random axes and reference points, other speeds and either solution.
  kanexpr::symbolic::matrix in_other_form(int variant) const {
    namespace mechanics = kanexpr::mechanics;
    mechanics::multibody_system other(b.system());
    mechanics::formulation& form = other.mechanism.formulated;
    form.solved_by =
        variant % 2 == 0 ? mechanics::solution::elimination : mechanics::solution::articulated_bodies;
    if (variant >= 2) form.speeds = mechanics::internal_speeds::absolute;
    const int frames = other.mechanism.frames.size();
    for (int f = 1; f < frames; ++f)
      form.frames.push({f, (7 * f + 5 * variant) % frames, (f + variant) % 3 == 0});
    return equations(other).get(quantity::udot);
  }

  // Every point and frame, and F_r*, with accelerations for some rates of the speeds.
  void compare_motion(equations& derived, const recipe::building& built) {
    namespace mechanics = kanexpr::mechanics;
    std::vector<double> udot;
    for (std::size_t i = 0; i < m.u.size(); ++i) udot.push_back(std::sin(static_cast<double>(7 * i + 1)));
    const VectorXd rates = VectorXd::Map(udot.data(), static_cast<Eigen::Index>(udot.size()));
    const VectorXd inertia = expected.inertia_bias - newton_euler::times(expected.mass_matrix, rates);
    const double size = 1 + expected.force_scale + expected.mass_matrix.diagonal().sum();
    expect_equal(recipe::number(m, derived.get(quantity::inertia_forces), udot), inertia, size,
                 "inertia forces");

    kanexpr::symbolic::matrix all(b.graph(), 0, 3);
    MatrixXd numbers(2 * (m.points.size() + m.frames.size()), 3);
    const auto add = [&](const mechanics::vector& found, const Eigen::Vector3d& wanted) {
      const mechanics::components c =
          mechanics::express(b.mechanism(), found, mechanics::mechanism::inertial);
      for (int i = 0; i < 3; ++i) all.entries.push(c[i]);
      numbers.row(all.rows++) = wanted;
    };
    const newton_euler::motion k = newton_euler::move(m, m.u);
    const newton_euler::partial_motions partial(m);
    for (std::size_t i = 0; i < m.points.size(); ++i) {
      const int p = place(built.points[i]);
      add(mechanics::velocity_of_point(derived.moving(), p), k.v[i]);
      add(mechanics::acceleration_of_point(derived.moving(), p),
          k.a[i] + newton_euler::sum(partial.velocity(i), udot));
    }
    for (std::size_t i = 0; i < m.frames.size(); ++i) {
      const int f = place(built.frames[i]);
      add(mechanics::angular_velocity_of_frame(derived.moving(), f), k.omega[i]);
      add(mechanics::angular_acceleration_of_frame(derived.moving(), f),
          k.alpha[i] + newton_euler::sum(partial.angular(i), udot));
    }
    expect_equal(recipe::number(m, all, udot), numbers, 1, "motion");
  }
};

void compare(unsigned first, unsigned last) {
  unsigned singular = 0;
  for (unsigned seed = first; seed < last && !testing::Test::HasFailure(); ++seed) {
    SCOPED_TRACE("mechanism " + std::to_string(seed));
    comparison one(seed);
    one.run();
    if (!one.regular) ++singular;
  }
  EXPECT_LT(singular, (last - first) / 10);
}

TEST(random_mechanism, obeys_newton_and_euler) { compare(0, 400); }

} // namespace
