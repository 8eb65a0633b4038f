// builds: clang++ all
// The bicycle with its gain schedule, compared with the linear equations of the benchmark in NumPy and SciPy.
#include "control/matrices.hpp"
#include "loops/references.hpp"
#include "no_heap.hpp"

#include <kanexpr/assemble.hpp>
#include <kanexpr/fixed_step.hpp>
#include <loops/balanced_bicycle.hpp>

#include <Eigen/Eigenvalues>

namespace {

using namespace balanced_bicycle;
using references::close;
using lin = linearization<Driven>;
namespace known = references::bicycle;

const lin::parameters none;

TEST(balanced_bicycle, has_the_gains_of_scipy) {
  for (int row = 0; row < 9; ++row)
    for (int i = 0; i < 4; ++i)
      EXPECT_NEAR(gains.at[row](0, i), known::gains[row][i], 1e-9 * std::abs(known::gains[row][i])) << row;
}

lin::state upright_at(double v) {
  lin::state x;
  x[u3] = v / rear_radius, x[u6] = v / front_radius;
  return x;
}

// Over one period, also between the speeds of the table. Without the torque, the bicycle falls below the
// weave speed of 4.3 m/s, and capsizes slowly above 6 m/s.
TEST(balanced_bicycle, is_stable_at_every_speed) {
  for (int i = 0; i < 33; ++i) {
    const double v = known::speeds[i];
    const auto [a, b] = lin::explicit_form(upright_at(v), none, lin::inputs(0, 0));
    const std::array places{1, 2, 3, 5};
    const Eigen::Matrix4d of_places = a(places, places);
    const Eigen::Vector4d of_torque = b(places, 0);
    const auto linear = discretize(of_places, of_torque, period);
    const Eigen::Matrix4d closed = linear.A - linear.B * numeric::as_eigen(gains(v));
    const double open_radius = linear.A.eigenvalues().cwiseAbs().maxCoeff(),
                 closed_radius = closed.eigenvalues().cwiseAbs().maxCoeff();
    EXPECT_NEAR(open_radius, known::radius_open[i], 1e-11) << v;
    EXPECT_NEAR(closed_radius, known::radius_closed[i], 1e-9) << v;
    EXPECT_LT(closed_radius, 0.975) << v;
    if (v < 4.25) {
      EXPECT_GT(open_radius, 1) << v;
    }
  }
}

// The motion is so small that the linear equations are accurate.
TEST(balanced_bicycle, moves_as_in_scipy_where_it_hardly_leans) {
  constexpr int finer = 10;
  lin::state x = upright_at(known::small_speed);
  x[q2] = known::small_start[0], x[q5] = known::small_start[1];
  x[u2] = known::small_start[2], x[u5] = known::small_start[3];
  ASSERT_TRUE(assemble<Driven>(x, none, lin::inputs(0, 0)));
  double t = 0;
  for (int part = 0; part < 6; ++part) {
    for (int k = 0; k < 50; ++k) {
      const lin::inputs r = torques(x, known::small_speed);
      for (int i = 0; i < finer; ++i) ASSERT_TRUE(runge_kutta_4<Driven>{}(t, x, period / finer, none, r));
    }
    const Eigen::Vector4d found(x[q2], x[q5], x[u2], x[u5]);
    EXPECT_TRUE(close(found, Eigen::Map<const Eigen::Vector4d>(known::small_motion[part]), 1e-8));
  }
}

TEST(balanced_bicycle, stays_upright_while_it_slows_down) {
  loop<double> moving(0.4);
  no_heap::guard guard;
  while (moving.t < 12) {
    const status made = moving.go_on();
    ASSERT_TRUE(made) << made.cause();
    EXPECT_LT(std::abs(moving.x[q2]), moving.t < 2 ? 0.2 : 0.05) << moving.t;
  }
  EXPECT_NEAR(rear_radius * moving.x[u3], slowest, 0.01);
}

// At 3 m/s, with the hands on or off the handlebars: the greatest lean after some seconds.
template <class Inputs>
double lean_at_3(const Inputs& inputs) {
  lin::state x = upright_at(3);
  x[u2] = 0.1;
  double most = 0;
  for (double t = 0; t < 10 && most < 0.7; most = std::max(most, std::abs(x[q2])))
    if (const status made = passing<runge_kutta_4<Driven>>{}(t, x, period, none, inputs(x)); !made) {
      ADD_FAILURE() << made.cause() << " at t = " << t;
      break;
    }
  return most;
}

TEST(balanced_bicycle, falls_without_its_controller) {
  EXPECT_GT(lean_at_3([](const lin::state&) { return lin::inputs(0, 0); }), 0.7);
  EXPECT_LT(lean_at_3([](const lin::state& x) { return torques(x, 3.0); }), 0.05);
}

TEST(balanced_bicycle, stays_upright_in_single_precision) {
  loop<float> moving(0.4F);
  while (moving.t < 12) {
    ASSERT_TRUE(moving.go_on());
    EXPECT_LT(std::abs(moving.x[q2]), moving.t < 2 ? 0.2F : 0.05F) << moving.t;
  }
}

} // namespace
