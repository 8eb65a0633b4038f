// An arm of two bars whose torques are computed a thousand times a second, so that the errors e of its angles
// obey ë + 10 ė + 25 e = 0.
#include <kanexpr/fixed_step.hpp>

#include <models/double_pendulum.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace kanexpr;
using namespace double_pendulum;
using eom = equations_of_motion<System>;

struct wanted {
  Eigen::Vector2d angles, rates, accelerations;
};

wanted wanted_at(double t) {
  const double s = std::sin(2 * t), c = std::cos(2 * t);
  return {{-0.8 + 0.6 * s, 0.9 + 0.5 * c}, {1.2 * c, -1.0 * s}, {-2.4 * s, -2.0 * c}};
}

// T1 − T2 acts on the upper bar and T2 on the lower one; the speeds are u1 = q1' and u2 = q1' + q2'.
eom::inputs torques(double t, const eom::state& x, const eom::parameters& p) {
  const wanted w = wanted_at(t);
  const Eigen::Vector2d rates(x[u1], x[u2] - x[u1]);
  const Eigen::Vector2d a = w.accelerations + 10 * (w.rates - rates) + 25 * (w.angles - x.q());
  const auto [M, f] = eom::together(eom::mass_matrix, eom::forcing)(x, p, eom::inputs::Zero());
  const Eigen::Vector2d missing = M * Eigen::Vector2d(a(0), a(0) + a(1)) - f;
  eom::inputs r;
  r[T1] = missing(0) + missing(1);
  r[T2] = missing(1);
  return r;
}

// Without the pauses between two torques the error would be (e₀ + (ė₀ + 5 e₀) t) exp(−5 t).
TEST(control, of_an_arm_with_fixed_steps_lets_its_error_decay) {
  eom::parameters p;
  p << 1.1, 0.6, 0.4, 0.35, 0.9, 0.07, 0.02, 9.81, 0.03, 0.02;
  eom::state x;
  x.setZero();
  x[q1] = -1.6;
  x[q2] = 0.2;
  const Eigen::Vector2d error = x.q() - wanted_at(0).angles, rate = -wanted_at(0).rates;
  double t = 0;
  for (int i = 1; i <= 500; ++i) {
    ASSERT_TRUE(runge_kutta_4<System>{}(t, x, 0.001, p, torques(t, x, p)));
    if (i != 100 && i != 300 && i != 500) continue;
    const Eigen::Vector2d expected = (error + (rate + 5 * error) * t) * std::exp(-5 * t);
    EXPECT_LE((x.q() - wanted_at(t).angles - expected).norm(), 0.01 * expected.norm()) << t;
  }
}

} // namespace
