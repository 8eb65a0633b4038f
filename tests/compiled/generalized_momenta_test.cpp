// builds: clang++
// ∂T/∂u of all speeds, compared with derivatives of the kinetic energy and with the momenta of simple bodies.
#include "compiled/complex_steps.hpp"

#include <kanexpr/symbolic.hpp>
#include <models/double_pendulum.hpp>
#include <models/four_bar.hpp>
#include <models/n_pendulum_cart.hpp>
#include <models/pivot_body.hpp>
#include <models/rolling_disc_constrained.hpp>
#include <models/rotating_tube.hpp>
#include <models/spinning_top.hpp>

#include <Eigen/Geometry>

namespace free_body {

using namespace kanexpr;

constexpr coordinate<"x"> x;
constexpr coordinate<"y"> y;
constexpr coordinate<"z"> z;
constexpr coordinate<"q"> q;
constexpr parameter<"m"> m;
constexpr parameter<"d"> d;
constexpr parameter<"I"> I;
constexpr parameter<"b"> b; // of the field

struct N : inertial_frame<N> {};
struct A : rotated<A, N, q, N::z> {};
struct O : origin<O, N> {};
struct P : offset<P, O, x * N::x + y * N::y + z * N::z> {};
struct C : offset<C, P, d * A::x> {};
struct Body : rigid_body<Body, C, A, m, inertia<A, I, 2 * I, 3 * I>> {};

/// It moves with P and rotates about the vertical; its mass center is to the side of P.
struct System : lagrange_system<inertial<N>, coordinates<x, y, z, q>, parameters<m, d, I>, bodies<Body>> {};

/// A charged particle in a magnetic field along N::z.
struct Charged : lagrange_system<
                     inertial<N>, coordinates<x, y>, parameters<m, b>,
                     lagrangian<m*(dot(x) * dot(x) + dot(y) * dot(y)) / 2 + b*(x* dot(y) - y * dot(x)) / 2>> {
};

} // namespace free_body

namespace {

using Eigen::VectorXd;

template <class System>
void expect_derivatives_of_the_energy() {
  using eom = kanexpr::equations_of_motion<System>;
  std::mt19937_64 source(5);
  for (int round = 0; round < 20; ++round) {
    const auto at = step_checks::random_point(source, step_checks::plain_point<System>(), 2);
    const auto energy = [](const auto&... arguments) {
      return Eigen::VectorXcd::Constant(1, eom::kinetic_energy(arguments...)).eval();
    };
    const VectorXd expected =
        step_checks::derivatives<System>(energy, at).middleCols(eom::coordinates, eom::speeds).transpose();
    const VectorXd found = [&] {
      no_heap::guard guard;
      return eom::generalized_momenta(at.t, at.x, at.p, at.r);
    }();
    EXPECT_LE((found - expected).norm(), 1e-13 * (1 + expected.norm()));
  }
}

TEST(generalized_momenta, are_derivatives_of_the_kinetic_energy) {
  expect_derivatives_of_the_energy<double_pendulum::System>();
  expect_derivatives_of_the_energy<n_pendulum_cart::System<3>>();
  expect_derivatives_of_the_energy<pivot_body::System>();    // speeds that are not coordinate rates
  expect_derivatives_of_the_energy<rotating_tube::System>(); // a prescribed motion
  expect_derivatives_of_the_energy<spinning_top::LagrangeSystem>();
}

TEST(generalized_momenta, of_constrained_systems_are_those_of_all_speeds) {
  expect_derivatives_of_the_energy<four_bar::System>();
  expect_derivatives_of_the_energy<four_bar::LagrangeSystem>();
  expect_derivatives_of_the_energy<rolling_disc_constrained::System>();
}

TEST(generalized_momenta, of_speeds_that_are_rates_are_those_of_the_body) {
  using namespace free_body;
  using eom = kanexpr::equations_of_motion<System>;
  const eom::state at{{x, 0.3},      {y, -0.2},      {z, 1},      {q, 0.7},
                      {dot(x), 1.5}, {dot(y), -0.5}, {dot(z), 2}, {dot(q), -3}};
  const eom::parameters p{{m, 2}, {d, 0.4}, {I, 0.1}};
  const Eigen::Vector4d momenta = eom::generalized_momenta(at, p);
  EXPECT_LT((momenta.head<3>() - eom::linear_momentum(at, p)).norm(), 1e-14);
  // about P: the angular momentum about the origin minus that of the linear momentum at P
  const Eigen::Vector3d place(at[x], at[y], at[z]);
  const Eigen::Vector3d about_point = eom::angular_momentum(at, p) - place.cross(momenta.head<3>());
  EXPECT_NEAR(momenta(3), about_point.z(), 1e-14);
  EXPECT_NEAR(momenta.dot(at.tail<4>()), 2 * eom::kinetic_energy(at, p), 1e-13);
}

TEST(generalized_momenta, of_a_given_lagrangian_are_canonical) {
  using namespace free_body;
  using eom = kanexpr::equations_of_motion<Charged>;
  const eom::state at{{x, 0.3}, {y, -0.2}, {dot(x), 1.5}, {dot(y), -0.5}};
  const Eigen::Vector2d momenta = eom::generalized_momenta(at, eom::parameters{{m, 2}, {b, 0.7}});
  EXPECT_NEAR(momenta(0), 2 * 1.5 + 0.7 * 0.2 / 2, 1e-15);
  EXPECT_NEAR(momenta(1), 2 * -0.5 + 0.7 * 0.3 / 2, 1e-15);
}

TEST(generalized_momenta, are_printed) {
  auto derived = kanexpr::derive<free_body::Charged>();
  EXPECT_EQ(print(derived.get(kanexpr::mechanics::quantity::generalized_momenta)),
            "[m*x' - b*y/2]\n[b*x/2 + m*y']");
}

} // namespace
