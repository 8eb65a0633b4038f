// builds: clang++ all
// F_r + F_r* of all speeds at given rates of the speeds.
#include "compiled/complex_steps.hpp"
#include "compiled/unreduced_forces.hpp"

#include <kanexpr/derivation/cost.hpp>
#include <models/double_pendulum.hpp>
#include <models/four_bar.hpp>
#include <models/n_pendulum_cart.hpp>
#include <models/pendulum_nonminimal.hpp>

namespace bearing {

using namespace kanexpr;

constexpr coordinate<"q"> q;
constexpr speed<"u"> u;
constexpr speed<"ux"> ux;
constexpr speed<"uy"> uy;
constexpr parameter<"m"> m;
constexpr parameter<"l"> l;
constexpr parameter<"g"> g;

struct N : inertial_frame<N> {}; // x points down
struct A : rotated<A, N, q, N::z> {};
struct O : origin<O, N> {};
struct Pivot : offset<Pivot, O, 0.0 * N::x>, velocity<N, ux * N::x + uy * N::y> {};
struct P : offset<P, Pivot, l * A::x> {};
struct Bob : particle<Bob, P, m> {};

/// A pendulum and the force in its bearing.
struct System
    : kane_system<inertial<N>, coordinates<q>, speeds<u>, auxiliary<ux, uy>, kinematics<dot(q) == u>,
                  bodies<Bob>, loads<gravity<g * N::x>>, parameters<m, l, g>> {};

} // namespace bearing

namespace {

using kanexpr::equations_of_motion;
using step_checks::plain_point;
using step_checks::random_point;

TEST(unreduced_forces, four_bar) { forces::balance_and_reduce<four_bar::System>(); }
TEST(unreduced_forces, pendulum_nonminimal) { forces::balance_and_reduce<pendulum_nonminimal::System>(); }

// f − M u̇ for unconstrained speeds.
TEST(unreduced_forces, without_constraints) {
  using eom = equations_of_motion<double_pendulum::System>;
  std::mt19937_64 source(2);
  for (int round = 0; round < 20; ++round) {
    const auto at = random_point(source, plain_point<double_pendulum::System>(), 3);
    const Eigen::Vector2d a = step_checks::random_numbers(source, 2, 5);
    const auto [M, f] = eom::together(eom::mass_matrix, eom::forcing)(at.x, at.p, at.r);
    const Eigen::Vector2d expected = f - M * a;
    EXPECT_LE((eom::unreduced_forces(at.x, at.p, at.r, a) - expected).norm(),
              1e-13 * (f.norm() + (M * a).norm()));
  }
}

// A single equation: that of the pendulum itself.
TEST(unreduced_forces, have_no_auxiliary_speeds) {
  using eom = equations_of_motion<bearing::System>;
  const double q = 0.3, u = -2, m = 2, l = 0.5, g = 9.81, a = 1.7;
  const auto force = eom::unreduced_forces(eom::state(q, u), eom::parameters(m, l, g), eom::inputs::Zero(),
                                           Eigen::Matrix<double, 1, 1>(a));
  static_assert(force.RowsAtCompileTime == 1);
  EXPECT_NEAR(force(0), -m * g * l * std::sin(q) - m * l * l * a, 1e-14);
}

// Inverse dynamics: every additional link takes the same number of operations.
template <int links>
int operations() {
  const kanexpr::symbolic::cost c = kanexpr::derivation::cost_of<n_pendulum_cart::System<links>>(
      {kanexpr::mechanics::quantity::unreduced_forces});
  return c.multiplications + c.additions;
}
TEST(unreduced_forces, grow_with_the_number_of_links) {
  EXPECT_EQ(operations<12>() - operations<8>(), operations<8>() - operations<4>());
}

} // namespace
