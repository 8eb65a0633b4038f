// builds: clang++ sanitize all
#include "models/andrews.hpp"
#include "models/chaplygin_sleigh.hpp"
#include "models/four_bar.hpp"
#include "models/pendulum_nonminimal.hpp"
#include "models/rolling_disc_constrained.hpp"
#include "runtime/agreement.hpp"
#include "runtime/dense_constraints.hpp"

namespace {

using kanexpr::mechanics::quantity;

TEST(agreement, four_bar) { agreement::check_rhs<four_bar::System>(); }
TEST(agreement, rolling_disc_constrained) { agreement::check_rhs<rolling_disc_constrained::System>(); }
TEST(agreement, chaplygin_sleigh) { agreement::check_rhs<chaplygin_sleigh::System>(); }
TEST(agreement, pendulum_nonminimal) { agreement::check_rhs<pendulum_nonminimal::System>(); }
TEST(agreement, andrews) { agreement::check_rhs<andrews::System>(); }

// All results of a constrained system, with one block that is solved with row exchanges.
TEST(agreement, dense_constraints) {
  using eom = kanexpr::equations_of_motion<dense_constraints::System>;
  auto derived = kanexpr::derive<dense_constraints::System>();
  ASSERT_EQ(derived.mistake(), "");
  const auto accelerations = derived.get(quantity::udot);
  kanexpr::base::sequence<int> outputs;
  for (const auto& rate : accelerations.entries) outputs.push(rate.node());
  ASSERT_EQ(derived.equations().singularity_checks_of(outputs).size(), 4); // a block, two pivots, finiteness
  const auto interpreted = [&](quantity q) { return derived.function(derived.get(q)); };
  auto udot = interpreted(quantity::udot), lambda = interpreted(quantity::multipliers),
       speeds = interpreted(quantity::dependent_speeds),
       residual = interpreted(quantity::constraint_residual),
       jacobian = interpreted(quantity::constraint_jacobian), dependency = interpreted(quantity::dependency),
       bias = interpreted(quantity::acceleration_bias);
  std::mt19937_64 source(3);
  int solved = 0;
  for (int round = 0; round < 50; ++round) {
    const auto x = agreement::random<eom::state>(source, -3, 3);
    const auto p = agreement::random<eom::parameters>(source, 0.5, 2);
    const auto r = agreement::random<eom::inputs>(source, -5, 5);
    const double t = x(0);
    const auto [a, l, u, left, j, d, b] =
        eom::together(eom::udot, eom::multipliers, eom::dependent_speeds, eom::constraint_residual,
                      eom::constraint_jacobian, eom::dependency, eom::acceleration_bias)(t, x, p, r);
    solved += a.status ? 1 : 0;
    agreement::expect_same_bits(a, udot(t, x, p, r));
    EXPECT_EQ(a.status.cause(), udot.status().cause());
    agreement::expect_same_bits(l, lambda(t, x, p, r));
    agreement::expect_same_bits(u, speeds(t, x, p, r));
    agreement::expect_same_bits(left, residual(t, x, p, r));
    agreement::expect_same_bits(j, jacobian(t, x, p, r));
    agreement::expect_same_bits(d, dependency(t, x, p, r));
    agreement::expect_same_bits(b, bias(t, x, p, r));
    // and they are correct: the residual vanishes at the dependent speeds
    auto placed = x;
    constexpr int dependent[]{1, 2, 3, 5};
    for (int i = 0; i < 4; ++i) placed(6 + dependent[i]) = u(i);
    EXPECT_LE(eom::velocity_residual(t, placed, p, r).norm(), 1e-12 * (1 + j.norm() * placed.norm()));
  }
  EXPECT_GE(solved, 45); // the others are too close to singular states
}

} // namespace
