// builds: clang++
// A bouncing ball: compiled and interpreted code, batches, linearization and constant expressions.
#include "runtime/agreement.hpp"

#include <kanexpr/batch.hpp>
#include <kanexpr/compiled/constant_values.hpp>
#include <kanexpr/kanexpr.hpp>

#include <models/bouncing_ball.hpp>

namespace {

using namespace kanexpr;
using namespace bouncing_ball;
using eom = equations_of_motion<System>;

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
