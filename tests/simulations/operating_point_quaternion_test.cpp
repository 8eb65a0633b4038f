// builds: clang++ all
// A body that hangs at rest: the search keeps the norm of its quaternion at 1.
#include <kanexpr/operating_point.hpp>

#include <models/pivot_body.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace kanexpr;
using namespace pivot_body;

const given_parameters<System> parameters{
    {m, 2}, {Ixx, 1}, {Iyy, 2}, {Izz, 2.5}, {Ixy, 0.1}, {g, 9.81}, {pivot_body::a, 0.1}, {b, 0.2}, {c, -0.3}};

TEST(operating_point, has_a_quaternion_of_norm_one) {
  const operating_point<System> still({{e0, 0.8}, {e1, 0.1}, {e2, 0.3}, {e3, 0.2}}, parameters,
                                      {.held = {T1, T2, T3}});
  ASSERT_TRUE(still) << still.cause();
  EXPECT_NEAR(still.x.q().norm(), 1, 1e-15);
  EXPECT_LT(still.x.u().norm(), 1e-14);
  EXPECT_EQ(still.freedom, 1); // about the vertical
  // The mass center, (0.1, 0.2, −0.3) in the body, is straight below the pivot.
  const Eigen::Vector3d at = function<System, position_of<G, O>>{}(still.x, still.p, still.r);
  EXPECT_NEAR(at.z(), -std::sqrt(0.14), 1e-14);
  EXPECT_EQ(still.residuals()[0].name, "the norm of quaternion 1");
}

} // namespace
