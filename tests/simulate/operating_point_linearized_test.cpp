// An operating point as a system that is derived while the program runs is linearized about it.
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

} // namespace
