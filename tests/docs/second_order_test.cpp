// builds: clang++
// Second order and identification: docs/guide/second-order.md, docs/guide/identification.md.
#include "docs/printed.hpp"
#include "docs/text.hpp"
#include "models/double_pendulum.hpp"
#include "models/simple_pendulum.hpp"

#include <kanexpr/runtime/base_parameters.hpp>
#include <kanexpr/steps/second_order_step.hpp>
#include <kanexpr/symbolic.hpp>

#include <gtest/gtest.h>

#include <iostream>

namespace {

using namespace kanexpr;

namespace two_bars {

using namespace double_pendulum;

TEST(second_order, by_the_compiler) {
  const state<System> x(Eigen::Vector4d(0.3, -0.8, 1.1, 0.2));
  const parameter_values<System> p = parameter_values<System>::Ones();
  const input_values<System> r(0.4, -0.1);
#include <docs/guide/second-order/parameters.cpp>
  EXPECT_EQ(of_speeds.rows(), 2);
  {
#include <docs/guide/second-order/compiled.cpp>
    EXPECT_TRUE(H.status);
    EXPECT_EQ(H, H.transpose());
    EXPECT_LE((H * v - Hv).norm(), 1e-12 * H.norm());
    EXPECT_NEAR(g.dot(v), dx.dot(w), 1e-12 * g.norm());
    const double t = 0, h = 1e-3;
#include <docs/guide/second-order/step.cpp>
    EXPECT_TRUE(H_d.status);
    EXPECT_LE((H_d * v - Hv_d).norm(), 1e-12 * H_d.norm());
  }
}

TEST(identification, of_two_bars) {
  const state<System> x(Eigen::Vector4d(0.3, -0.8, 1.1, 0.2));
  parameter_values<System> p = parameter_values<System>::Ones();
  p[l1] = 0.5;
  const input_values<System> r(0.4, -0.1);
  const Eigen::Vector2d a(0.7, -0.2);
  const docs::printed here;
#include <docs/guide/identification/compiled.cpp>
  const std::size_t names = here.text().size();
#include <docs/guide/identification/base.cpp>
  EXPECT_EQ(here.text().substr(names), docs::text("docs/guide/identification/base.text"));
  const Eigen::Vector2d inverse = equations_of_motion<System>::inverse_dynamics(x, p, r, a);
  EXPECT_LE((tau - inverse).norm(), 1e-12 * (Y.cwiseAbs() * pi).norm());
  EXPECT_LE((Y * pi - Y_base * pi_base).norm(), 1e-10 * (Y.cwiseAbs() * pi).norm());
}

} // namespace two_bars

namespace pendulum {

using namespace simple_pendulum;

TEST(second_order, is_printed) {
  const Eigen::Vector2d x(0.3, 0.2), w(0, 1);
  const Eigen::VectorXd p = Eigen::VectorXd::Ones(parameter_values<System>().size()), r;
  const docs::printed here;
#include <docs/guide/second-order/run_time.cpp>
  EXPECT_EQ(here.text(), docs::text("docs/guide/second-order/run_time.text"));
  EXPECT_NEAR(found(0, 0), std::sin(0.3), 1e-15);
}

} // namespace pendulum
} // namespace
