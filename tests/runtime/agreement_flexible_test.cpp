// builds: clang++ all
// A beam with a rigid body at its end: compiled and interpreted code, batches, linearization, second order
// and fixed steps.
#include "runtime/second_order.hpp"
#include "runtime/slewing_arm.hpp"

#include <kanexpr/batch.hpp>
#include <kanexpr/fixed_step.hpp>
#include <kanexpr/kanexpr.hpp>

#include <cmath>

namespace {

using namespace kanexpr;

using System = slewing_arm::System;
using eom = equations_of_motion<System>;

TEST(agreement, flexible_arm) { agreement::check<System>(); }

TEST(agreement, batch_of_flexible_arms) {
  using two = batch<2>;
  std::mt19937_64 source(3);
  two::state<System> x;
  two::inputs<System> r;
  const auto p = agreement::random<eom::parameters>(source, 0.5, 2);
  for (std::size_t lane = 0; lane < 2; ++lane) {
    two::set(x, lane, agreement::random<eom::state>(source, -0.3, 0.3));
    two::set(r, lane, agreement::random<eom::inputs>(source, -1, 1));
  }
  const auto rates = eom::rhs(x, p, r);
  for (std::size_t lane = 0; lane < 2; ++lane)
    EXPECT_EQ(two::get(rates, lane), eom::rhs(two::get(x, lane), p, two::get(r, lane)));
}

TEST(agreement, linearization_of_a_flexible_arm) {
  using lin = linearization<System>;
  std::mt19937_64 source(4);
  const auto x = agreement::random<eom::state>(source, -0.3, 0.3);
  const auto p = agreement::random<eom::parameters>(source, 0.5, 2);
  const auto r = agreement::random<eom::inputs>(source, -1, 1);
  const auto [a, b] = lin::explicit_form(x, p, r);
  constexpr double h = 1e-5;
  for (Eigen::Index j = 0; j < x.size(); ++j) {
    eom::state after = x, before = x;
    after(j) += h, before(j) -= h;
    const eom::state difference = (eom::rhs(after, p, r) - eom::rhs(before, p, r)) / (2 * h);
    EXPECT_LE((a.col(j) - difference).norm(), 1e-7 * (1 + a.norm()));
  }
}

TEST(agreement, second_order_of_a_flexible_arm) {
  using namespace to_second_order;
  expect_second_order(derivatives(derive<System>()), 0.3);
}

// The arm swings freely, and its energy is constant.
TEST(agreement, steps_of_a_flexible_arm) {
  using namespace slewing_arm;
  parameter_values<System> p{{L, 1.5}, {rho, 0.7}, {EI, 8}, {m, 0.3}};
  const eom::inputs r(0.0);
  eom::state x = eom::state::Zero();
  x(1) = 0.05, x(3) = 2;
  const auto energy = [&] { return eom::kinetic_energy(x, p).value + eom::potential_energy(x, p).value; };
  const double before = energy();
  runge_kutta_4<System> step;
  double t = 0;
  for (int i = 0; i < 1000; ++i) ASSERT_TRUE(step(t, x, 1e-3, p, r));
  EXPECT_NEAR(energy(), before, 1e-8 * std::abs(before));
  EXPECT_GT(std::abs(x(1)), 1e-4); // it bends
}

} // namespace
