// builds: clang++ all
// The steady motion of a particle with a constant speed, under gravity and a force that follows an input.
#include <kanexpr/kanexpr.hpp>
#include <kanexpr/operating_point.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace of_constant_speed {

using namespace kanexpr;

constexpr coordinate<"x"> x;
constexpr coordinate<"h"> h;
constexpr speed<"u"> u;
constexpr speed<"w"> w;
constexpr state_variable<"F"> force_of_jet;
constexpr parameter<"c"> c;
constexpr input<"r"> r;

struct N : inertial_frame<N> {};
struct O : origin<O, N> {};
struct P : offset<P, O, x * N::x + h * N::y> {};
struct Bob : particle<Bob, P, 2> {};
struct System : kane_system<inertial<N>, coordinates<x, h>, speeds<u, w>, states<force_of_jet>,
                            kinematics<simple>, dynamics<0.5 * dot(force_of_jet) == r - force_of_jet>,
                            bodies<Bob>, loads<gravity<-10.0 * N::y>, force<P, force_of_jet * N::x>>,
                            velocity_constraints<u * u + w * w == c * c>, dependent<w>> {};

} // namespace of_constant_speed

namespace {

using namespace of_constant_speed;

// The velocity is parallel to the sum of the forces, so that these do not turn it.
TEST(operating_point, of_a_constraint_that_is_not_linear_in_the_speeds) {
  const kanexpr::operating_point<System> steady({{u, 1.5}, {w, -2.5}, {force_of_jet, 10}}, {{c, 3}},
                                                {.inputs = {{r, 15}}, .held = {r, x, h}, .changing = {x, h}});
  ASSERT_TRUE(steady) << steady.cause();
  const double whole = std::hypot(15, 20);
  EXPECT_NEAR(steady.x[u], 3 * 15 / whole, 1e-12);
  EXPECT_NEAR(steady.x[w], -3 * 20 / whole, 1e-12);
  EXPECT_NEAR(steady.x[force_of_jet], 15, 1e-12);
}

} // namespace
