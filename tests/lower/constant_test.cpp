// Results in constant expressions: most of the test takes place during compilation.
#include "models/rolling_disc.hpp"
#include "models/simple_pendulum.hpp"

#include <gtest/gtest.h>

namespace {

using pendulum = kanexpr::equations_of_motion<simple_pendulum::System>;
using disc = kanexpr::equations_of_motion<rolling_disc::System>;

// m l² with m = 2, l = 3
static_assert(pendulum::mass_matrix.constant({0.5, 0}, {2, 3, 10, 0})(0, 0) == 18);
// at rest, hanging straight down
static_assert(pendulum::udot.constant({0, 0}, {2, 3, 10, 0}, {0})(0) == 0);
static_assert(pendulum::kinetic_energy.constant({0.5, 4}, {2, 3, 10, 0}) == 144);

// 5/4 m r², 3/2 m r², 1/4 m r² with m = 8, r = 2
constexpr auto mass_matrix = disc::mass_matrix.constant({0.1, 0.2, 0.3, 1, 2, 3}, {8, 2, 9.81});
static_assert(mass_matrix(0, 0) == 40 && mass_matrix(1, 1) == 48 && mass_matrix(2, 2) == 8);
static_assert(mass_matrix(0, 1) == 0 && mass_matrix(1, 2) == 0 && mass_matrix(2, 0) == 0);

TEST(constant, agrees_with_evaluation) {
  constexpr auto udot = disc::udot.constant({0.1, 0.2, 0.3, 1, 2, 3}, {8, 2, 9.81});
  const Eigen::Vector3d evaluated =
      disc::udot((disc::state() << 0.1, 0.2, 0.3, 1, 2, 3).finished(), disc::parameters(8, 2, 9.81));
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(udot(i), evaluated(i), 1e-14 * evaluated.norm());
}

} // namespace
