// builds: clang++ all
// A bouncing ball, and a block that sticks and slips: compiled and interpreted code, batches, linearization
// and constant expressions.
#include "runtime/agreement.hpp"

#include <kanexpr/batch.hpp>
#include <kanexpr/compiled/constant_values.hpp>
#include <kanexpr/kanexpr.hpp>

#include <models/bouncing_ball.hpp>
#include <models/stick_slip.hpp>

namespace {

using namespace kanexpr;
using namespace bouncing_ball;
using eom = equations_of_motion<System>;

using rough_ground = contact<sphere_on_plane<C, r, O, N::z, B>, elastic<k, 1.5>, smoothed_over<d>,
                             restitution<0.8, v>, lugre_friction<mu, 0.2, 0.01, 1e3, 30, 0.4>>;
struct RoughSystem
    : kane_system<inertial<N>, coordinates<x, z, q>, speeds<vx, vz, w>,
                  kinematics<dot(x) == vx, dot(z) == vz, dot(q) == w>, parameters<m, r, k, d, v, mu, g>,
                  bodies<Ball>, loads<gravity<-g * N::z>, rough_ground>> {};

TEST(agreement, ball_on_bristles) { agreement::check<RoughSystem>(); }

TEST(agreement, linearization_of_stick_slip) {
  namespace block = stick_slip;
  using equations = equations_of_motion<block::System>;
  const equations::parameters p{
      {block::m, 1},  {block::k, 2},      {block::l, 0.6},      {block::V, 0.1},        {block::Fs, 1.5},
      {block::Fc, 1}, {block::vs, 0.001}, {block::sigma0, 1e5}, {block::sigma1, 316.2}, {block::sigma2, 0.4}};
  for (const double speed : {0.0, 3e-7, -2e-3, 0.2}) {
    const equations::state at{{block::x, 0.1}, {block::v, speed}, {block::bristle, 7e-6}};
    const auto [a, none] = linearization<block::System>::explicit_form(0.3, at, p);
    for (Eigen::Index j = 0; j < 3; ++j) {
      const double step = j == 1 ? 1e-9 : 1e-8;
      equations::state after = at, before = at;
      after(j) += step, before(j) -= step;
      const equations::state difference =
          (equations::rhs(0.3, after, p) - equations::rhs(0.3, before, p)) / (2 * step);
      EXPECT_LE((a.col(j) - difference).norm(), 1e-5 * (1 + a.norm())) << speed << " " << j;
    }
  }
}

TEST(agreement, bouncing_ball) { agreement::check<System>(); }

constexpr auto in_contact =
    constant_state<System>({{x, 0.1}, {z, 0.0995}, {q, 0}, {vx, 0.2}, {vz, -0.5}, {w, 3}});
constexpr auto values = constant_parameters<System>(
    {{m, 0.05}, {r, 0.1}, {k, 2e4}, {d, 1e-4}, {v, 4}, {mu, 0.4}, {b, 0.004}, {s, 0.05}, {g, 9.81}});
constexpr auto rates = eom::rhs.constant(in_contact, values);
// k δ^1.5 (1 + c δ̇)/m − g with δ = 0.5 mm
static_assert(rates(4) > 2e4 * 1.118e-5 * 1.0465 / 0.05 - 9.81 &&
              rates(4) < 2e4 * 1.1181e-5 * 1.0468 / 0.05 - 9.81);

eom::state state_at(double height) { return {{x, 0.1}, {z, height}, {q, 0}, {vx, 0.2}, {vz, -0.5}, {w, 3}}; }
const eom::parameters numbers{{m, 0.05}, {r, 0.1},   {k, 2e4},  {d, 1e-4}, {v, 4},
                              {mu, 0.4}, {b, 0.004}, {s, 0.05}, {g, 9.81}};

TEST(agreement, bouncing_ball_in_constant_expressions) {
  const eom::state called = eom::rhs(state_at(0.0995), numbers);
  for (int i = 0; i < 6; ++i) EXPECT_EQ(rates(i), called(i)) << i;
}

TEST(agreement, batch_of_bouncing_balls) {
  using two = batch<2>;
  two::state<System> both;
  two::set(both, 0, state_at(0.0995)), two::set(both, 1, state_at(0.3));
  const auto found = eom::rhs(both, numbers);
  EXPECT_EQ(two::get(found, 0), eom::rhs(state_at(0.0995), numbers));
  EXPECT_EQ(two::get(found, 1), eom::rhs(state_at(0.3), numbers));
}

TEST(agreement, linearization_of_a_bouncing_ball) {
  for (const double height : {0.0995, 0.09998, 0.10005, 0.3}) {
    const eom::state at = state_at(height);
    const auto [a, none] = linearization<System>::explicit_form(at, numbers);
    for (Eigen::Index j = 0; j < 6; ++j) {
      const double step = j < 3 ? 1e-9 : 1e-6;
      eom::state after = at, before = at;
      after(j) += step, before(j) -= step;
      const eom::state difference = (eom::rhs(after, numbers) - eom::rhs(before, numbers)) / (2 * step);
      EXPECT_LE((a.col(j) - difference).norm(), 1e-6 * (1 + a.norm())) << height << " " << j;
    }
  }
}

} // namespace
