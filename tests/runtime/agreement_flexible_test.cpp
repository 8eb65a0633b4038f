// builds: clang++
// A beam with a rigid body at its end: compiled and interpreted code, batches, linearization and fixed steps.
#include "runtime/agreement.hpp"

#include <kanexpr/batch.hpp>
#include <kanexpr/beams.hpp>
#include <kanexpr/fixed_step.hpp>
#include <kanexpr/kanexpr.hpp>

#include <cmath>

namespace {

using namespace kanexpr;

namespace slewing_arm {

constexpr coordinate<"q"> q;
constexpr speed<"u"> u;
constexpr input<"T"> T;
constexpr parameter<"L"> L;
constexpr parameter<"rho"> rho;
constexpr parameter<"EI"> EI;
constexpr parameter<"m"> m;

struct N : inertial_frame<N> {};
struct O : origin<O, N> {};
struct Hub : rotated<Hub, N, q, N::z> {};
struct Root : offset<Root, O, 0.1 * Hub::x> {};
struct Arm : beam<Arm, Root, Hub::x, L, rho, bending<Hub::y, EI, clamped_free<2>>> {};
struct Tip : section<Tip, Arm, 1> {};
struct Center : offset<Center, Tip, 0.2 * Tip::x> {};
struct Load : rigid_body<Load, Center, Tip, m, inertia<Tip, 0, 0, 0.03 * m>> {};
struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>,
                            bodies<Arm, Load>, loads<torque<Hub, T * N::z>, gravity<-9.81 * N::y>>> {};

} // namespace slewing_arm

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
