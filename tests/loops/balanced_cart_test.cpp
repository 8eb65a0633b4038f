// builds: clang++
// The cart with its filter and regulator, compared with the same loop in NumPy and SciPy with the same noise.
#include "control/matrices.hpp"
#include "loops/references.hpp"
#include "no_heap.hpp"

#include <loops/balanced_cart.hpp>

namespace {

using namespace balanced_cart;
using references::close;
using references::eigen;
namespace known = references::cart;

const state<cart> start(-0.5, upright + 0.2, 0, 0), guess(-0.4, upright + 0.1, 0, 0);

TEST(balanced_cart, has_the_gain_of_scipy) {
  for (int i = 0; i < 4; ++i)
    EXPECT_NEAR(regulator.K(0, i), known::gain[i], 1e-10 * std::abs(known::gain[i]));
}

TEST(balanced_cart, moves_and_estimates_as_in_numpy) {
  loop<double> moving(start, guess);
  no_heap::guard guard;
  for (int second = 0; second < 5; ++second) {
    for (int k = 0; k < 200; ++k) {
      const status made = moving.go_on();
      ASSERT_TRUE(made) << made.cause();
    }
    EXPECT_TRUE(close(moving.x, Eigen::Map<const Eigen::Vector4d>(known::truths[second]), 1e-11));
    EXPECT_TRUE(
        close(moving.control.estimate.x, Eigen::Map<const Eigen::Vector4d>(known::estimates[second]), 1e-11));
    EXPECT_TRUE(close(moving.control.estimate.P, eigen(known::covariances[second]), 1e-10));
    EXPECT_NEAR(moving.control.force[F], known::forces[second], 1e-9);
  }
  EXPECT_NEAR(moving.t, 5, 1e-12);
}

TEST(balanced_cart, falls_without_its_controller) {
  state<cart> x = start;
  double t = 0;
  while (x[q<1>] < upright + 1 && t < 5)
    ASSERT_TRUE(runge_kutta_4<cart>{}(t, x, period, parameters_in<double>(), input_values<cart>(0.0)));
  EXPECT_LT(t, 1);
}

TEST(balanced_cart, stays_upright_in_single_precision) {
  loop<float> moving(start.cast<float>(), guess.cast<float>());
  for (int k = 0; k < 4000; ++k) {
    ASSERT_TRUE(moving.go_on());
    if (k < 800) continue;
    EXPECT_NEAR(moving.x[q<0>], 0, 0.2);
    EXPECT_NEAR(moving.x[q<1>], upright, 0.05);
  }
}

TEST(balanced_cart, says_what_its_sensors_did_not) {
  controller<double> control(guess, 1e-4 * Eigen::Matrix4d::Identity());
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(control({0, none}).cause(), "a measurement is not finite");
  EXPECT_EQ(control.force[F], 0);
}

} // namespace
