// builds: clang++
// Lagrange's method: docs/guide/lagrange.md.
#include <kanexpr/assemble.hpp>
#include <kanexpr/symbolic.hpp>

#include <gtest/gtest.h>

namespace {

using namespace kanexpr;

constexpr parameter<"m"> m;
constexpr parameter<"g"> g;
struct N : inertial_frame<N> {};
struct O : origin<O, N> {};

namespace constrained {

constexpr coordinate<"q1"> q1;
constexpr coordinate<"q2"> q2;
constexpr parameter<"L"> L;
struct P : offset<P, O, q1 * N::x + q2 * N::y> {};
struct Bob : particle<Bob, P, m> {};

#include <docs/guide/lagrange/pendulum.cpp>

TEST(lagrange, has_a_state) {
  const parameter_values<System> p{{m, 2}, {g, 9.81}, {L, 0.5}};
#include <docs/guide/lagrange/state.cpp>
  EXPECT_TRUE(a.status);
  EXPECT_TRUE((check_consistency<System>(x, p)));
  EXPECT_EQ(lambda.size(), 1);
}

} // namespace constrained

namespace by_lagrangian {

constexpr coordinate<"q"> q;
constexpr parameter<"l"> l;
constexpr parameter<"c"> c;
struct A : rotated<A, N, q, N::z> {};
struct P : offset<P, O, l * A::x> {};

#include <docs/guide/lagrange/lagrangian.cpp>

struct FromGeometry : lagrange_system<inertial<N>, coordinates<q>, parameters<m, l, g, c>,
                                      loads<torque<A, -c * dot(q) * N::z>>,
#include <docs/guide/lagrange/from_geometry.cpp>
                                      > {
};

TEST(lagrange, takes_a_lagrangian) {
  auto model = derive<System>();
  EXPECT_EQ(symbolic::print(model.mass_matrix()), "[l^2*m]");
  EXPECT_EQ(symbolic::print(model.forcing()), "[-c*q' - g*l*m*sin(q)]");

  const state<System> x(0.3, 1.1);
  const parameter_values<System> p(2, 0.5, 9.81, 0.1);
  EXPECT_NEAR(
      equations_of_motion<System>::udot(x, p)[0],
      equations_of_motion<FromGeometry>::udot(state<FromGeometry>(x), parameter_values<FromGeometry>(p))[0],
      1e-12);
}

} // namespace by_lagrangian
} // namespace
