// builds: clang++
// Expressions of a model as compiled functions, compared with numerical derivatives of positions along the
// motion.
#include "models/arm3.hpp"
#include "models/rolling_disc.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

namespace {

using namespace kanexpr;

using tip = arm3::Center<3, arm3::J3, arm3::B3>;

template <class System>
struct sample {
  using eom = equations_of_motion<System>;
  typename eom::state x;
  typename eom::parameters p;
  typename eom::inputs r;

  sample() {
    for (Eigen::Index i = 0; i < x.size(); ++i) x(i) = 0.3 + 0.17 * static_cast<double>(i);
    for (Eigen::Index i = 0; i < p.size(); ++i) p(i) = 0.4 + 0.05 * static_cast<double>(i);
    for (Eigen::Index i = 0; i < r.size(); ++i) r(i) = 0.2 - 0.3 * static_cast<double>(i);
  }

  /// The derivative of `f` along the motion, by a central difference of fourth order.
  template <class Function>
  auto along_motion(Function f) const {
    const double h = 1e-3;
    const auto at = [&](double t) {
      // the state after a time t, to fourth order
      typename eom::state s = x;
      const int steps = 4;
      for (int i = 0; i < steps; ++i) {
        const double dt = t / steps;
        const auto k1 = eom::rhs(s, p, r);
        const typename eom::state s2(s + dt / 2 * k1);
        const auto k2 = eom::rhs(s2, p, r);
        const typename eom::state s3(s + dt / 2 * k2);
        const auto k3 = eom::rhs(s3, p, r);
        const typename eom::state s4(s + dt * k3);
        s += dt / 6 * (k1 + 2 * k2 + 2 * k3 + eom::rhs(s4, p, r));
      }
      return f(s, p, r);
    };
    return ((8 * (at(h) - at(-h)) - (at(2 * h) - at(-2 * h))) / (12 * h)).eval();
  }
};

constexpr double by_differences = 1e-8;

} // namespace

TEST(expressions, velocity_is_the_rate_of_position) {
  using arm = arm3::System;
  const sample<arm> s;
  const auto position = [](const auto&... a) { return function<arm, position_of<tip, arm3::J1>>{}(a...); };
  const Eigen::Vector3d v = function<arm, velocity_of<tip>>{}(s.x, s.p);
  EXPECT_TRUE(v.isApprox(s.along_motion(position), by_differences)) << v.transpose();
}

TEST(expressions, acceleration_is_the_rate_of_velocity) {
  using arm = arm3::System;
  const sample<arm> s;
  const auto velocity = [](const auto&... a) { return function<arm, velocity_of<tip>>{}(a...); };
  const Eigen::Vector3d a = function<arm, acceleration_of<tip>>{}(s.x, s.p, s.r);
  EXPECT_TRUE(a.isApprox(s.along_motion(velocity), by_differences)) << a.transpose();
}

TEST(expressions, angular_acceleration_is_the_rate_of_angular_velocity) {
  using arm = arm3::System;
  const sample<arm> s;
  const auto turning = [](const auto&... a) { return function<arm, angular_velocity_of<arm3::B3>>{}(a...); };
  const Eigen::Vector3d a = function<arm, angular_acceleration_of<arm3::B3>>{}(s.x, s.p, s.r);
  EXPECT_TRUE(a.isApprox(s.along_motion(turning), by_differences)) << a.transpose();
  const Eigen::Vector3d seen =
      function<arm, derivative_in<arm3::N>(angular_velocity_of<arm3::B3>)>{}(s.x, s.p, s.r);
  EXPECT_TRUE(seen.isApprox(a, 1e-12));
}

TEST(expressions, jacobian_times_rates_is_the_velocity) {
  using arm = arm3::System;
  const sample<arm> s;
  constexpr auto wanted = jacobian(position_of<tip, arm3::J1>, arm3::q<1>, arm3::q<2>, arm3::q<3>);
  const Eigen::Matrix3d j = function<arm, wanted>{}(s.x, s.p);
  const Eigen::Vector3d v = function<arm, velocity_of<tip>>{}(s.x, s.p);
  EXPECT_TRUE((j * s.x.u()).isApprox(v, 1e-12)); // in the arm, the speeds are coordinate rates
}

TEST(expressions, partial_velocities_add_up) {
  using disc = rolling_disc::System;
  using rolling_disc::Dmc;
  const sample<disc> s;
  constexpr auto v = velocity_of<Dmc>;
  const Eigen::Vector3d sum =
      function<disc, partial(v, rolling_disc::u1)>{}(s.x, s.p) * s.x[rolling_disc::u1] +
      function<disc, partial(v, rolling_disc::u2)>{}(s.x, s.p) * s.x[rolling_disc::u2] +
      function<disc, partial(v, rolling_disc::u3)>{}(s.x, s.p) * s.x[rolling_disc::u3];
  EXPECT_TRUE(sum.isApprox(function<disc, v>{}(s.x, s.p), 1e-12));
}

TEST(expressions, scalars_and_chosen_axes) {
  using disc = rolling_disc::System;
  using namespace rolling_disc;
  const sample<disc> s;
  const Eigen::Vector3d v = function<disc, velocity_of<Dmc>>{}(s.x, s.p);
  const Eigen::Vector3d lean = function<disc, in_axes_of<L>(velocity_of<Dmc>)>{}(s.x, s.p);
  EXPECT_NEAR(lean(0), s.p[r] * s.x[u2], 1e-15);
  EXPECT_NEAR(lean(1), -s.p[r] * s.x[u1], 1e-15);
  EXPECT_EQ(lean(2), 0);
  const double speed = function<disc, magnitude(velocity_of<Dmc>)>{}(s.x, s.p);
  EXPECT_NEAR(speed, v.norm(), 1e-15);
  const double height = function<disc, dot(position_of<Dmc, C>, N::z)>{}(s.x, s.p);
  EXPECT_NEAR(height, s.p[r] * std::cos(s.x[q2]), 1e-15);
  // the derivative in the disc of a vector fixed in the disc is zero; in N it is ω × r
  const Eigen::Vector3d still = function<disc, derivative_in<R>(r * R::x)>{}(s.x, s.p);
  EXPECT_EQ(still.norm(), 0);
  const Eigen::Vector3d turning = function<disc, derivative_in<N>(r * R::x)>{}(s.x, s.p);
  const Eigen::Vector3d w = function<disc, angular_velocity_of<R>>{}(s.x, s.p);
  const Eigen::Vector3d arm = function<disc, r * R::x>{}(s.x, s.p);
  EXPECT_TRUE(turning.isApprox(w.cross(arm), 1e-12));
}
