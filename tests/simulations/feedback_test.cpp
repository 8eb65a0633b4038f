// builds: clang++ all
// A cart that balances a pendulum by state feedback, designed with the linearized equations.
#include <kanexpr/operating_point.hpp>
#include <kanexpr/simulate.hpp>

#include <models/n_pendulum_cart.hpp>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace {

using namespace kanexpr;
using namespace n_pendulum_cart;
using balanced = System<1>;
using lin = linearization<balanced>;

constexpr Eigen::Index order = lin::states;
using square = Eigen::Matrix<double, order, order>;
using column = Eigen::Vector<double, order>;

// K in r = −K x so that A − B K has the poles: Ackermann's formula.
Eigen::RowVector<double, order> feedback(const square& A, const column& B, const column& poles) {
  square controllability, polynomial = square::Identity();
  column next = B;
  for (Eigen::Index i = 0; i < order; ++i) {
    controllability.col(i) = next;
    next = A * next;
    polynomial = polynomial * (A - poles(i) * square::Identity());
  }
  return controllability.inverse().row(order - 1) * polynomial;
}

TEST(feedback, decays_like_its_slowest_pole) {
  const operating_point<balanced> upright({{q<1>, 1.4}}, {{m<0>, 1.5}, {m<1>, 0.4}, {l<0>, 0.8}, {g, 9.81}},
                                          {.held = {q<0>}});
  ASSERT_TRUE(upright) << upright.cause();
  EXPECT_NEAR(upright.x[q<1>], std::numbers::pi / 2, 1e-12);
  const auto [A, B] = lin::explicit_form(upright.x, upright.p, upright.r);
  const column poles{-5, -4, -3, -2};
  const auto K = feedback(A, B, poles);
  for (const double pole : poles)
    EXPECT_LE(std::abs((A - B * K - pole * square::Identity()).determinant()), 1e-9);

  state<balanced> start = upright.x;
  start[q<0>] = -1;
  start[q<1>] += 0.4;
  const auto run =
      simulate<balanced>(start, upright.p, {0, 8},
                         {.inputs = [&](double, const state<balanced>& x,
                                        input_values<balanced>& r) { r = upright.r - K * (x - upright.x); },
                          .output_every = 0.5});
  ASSERT_TRUE(run) << run.cause();
  const double before = run.trajectory.at(7)->x[q<0>], end = run.state[q<0>];
  EXPECT_LE(std::abs(end), 1e-5);
  EXPECT_NEAR(before / end, std::exp(2), 1e-3 * std::exp(2));
}

} // namespace
