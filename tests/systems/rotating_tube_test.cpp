#include "systems/check_constrained.hpp"

#include <models/rotating_tube.hpp>

namespace {

using namespace rotating_tube;
using eom = kanexpr::equations_of_motion<System>;

TEST(rotating_tube, agrees_with_the_oracle) { check::constrained_against_oracle<System>("rotating_tube"); }

// Its acceleration contains all derivatives of the prescribed angle: (u' - q theta'^2) along the tube, q
// theta'' + 2 u theta' across it.
TEST(rotating_tube, acceleration_holds_the_prescribed_motion) {
  const oracle::system reference = oracle::load("rotating_tube");
  const auto p = check::parameters_by_name<System>(reference.parameters);
  constexpr auto acceleration =
      kanexpr::function<System, kanexpr::in_axes_of<A>(kanexpr::acceleration_of<P>)>{};
  for (const oracle::state& s : reference.states) {
    const auto x = check::stacked<System>(s.q, s.u);
    eom::inputs r(s.r);
    const double turning = r[dot(theta)], change = r[dot(dot(theta))];
    const Eigen::Vector3d expected(s.udot(0) - x[q] * turning * turning, x[q] * change + 2 * x[u] * turning,
                                   0);
    EXPECT_TRUE(oracle::close(check::without_heap(acceleration, x, p, r), expected, 1e-12));
  }
}

} // namespace
