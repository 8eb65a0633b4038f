// builds: clang++
// The linearization of a run-time model at an operating point.
#include "models/simple_pendulum.hpp"

#include <kanexpr/operating_point.hpp>
#include <kanexpr/symbolic.hpp>

#include <gmock/gmock.h>

#include <cmath>

namespace {

using namespace simple_pendulum;
using testing::IsEmpty;

TEST(operating_point, is_linearized) {
  const kanexpr::operating_point<System> held({{q, 2.3}}, Eigen::Vector4d(2, 0.5, 9.81, 0.1), {.held = {q}});
  auto model = kanexpr::derive<System>();
  auto linear = model.linearize(held);
  EXPECT_THAT(linear.failures(), IsEmpty());
  const Eigen::MatrixXd A = model.function(linear.explicit_form().A)(Eigen::Vector2d::Zero());
  EXPECT_EQ(A(0, 1), 1);
  EXPECT_NEAR(A(1, 0), -9.81 / 0.5 * std::cos(2.3), 1e-13);
  EXPECT_NEAR(A(1, 1), -0.1 / (2 * 0.5 * 0.5), 1e-15);
}

// A spring that becomes stiffer: the equations are linearized at the time of the operating point.
constexpr parameter<"k"> k; // stiffness over time
struct Stiffening
    : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, parameters<m, l, k>,
                  inputs<T>, bodies<Bob>, loads<torque<A, (T - k * time_variable() * q) * N::z>>> {};

TEST(operating_point, is_linearized_at_its_time) {
  const kanexpr::operating_point<Stiffening> held({{q, 0.3}}, {{m, 2}, {l, 0.5}, {k, 0.1}},
                                                  {.held = {q}, .t = 1.7});
  ASSERT_TRUE(held) << held.cause();
  EXPECT_EQ(held.t, 1.7);
  EXPECT_NEAR(held.r[T], 0.1 * 1.7 * 0.3, 1e-15);
  EXPECT_NEAR(kanexpr::equations_of_motion<Stiffening>::udot(held.t, held.x, held.p, held.r)(0), 0, 1e-14);
  auto model = kanexpr::derive<Stiffening>();
  auto linear = model.linearize(held);
  EXPECT_THAT(linear.failures(), IsEmpty());
  const Eigen::MatrixXd A = model.function(linear.explicit_form().A)(Eigen::Vector2d::Zero());
  EXPECT_NEAR(A(1, 0), -0.1 * 1.7 / (2 * 0.5 * 0.5), 1e-14);
}

} // namespace
