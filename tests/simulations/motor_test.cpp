// builds: clang++ all
// A motor drives a four-bar linkage, whose loop stays closed.
#include <motion/four_bar.hpp>

#include <gtest/gtest.h>

#include <algorithm>

namespace {

using namespace four_bar;

TEST(energy, of_a_linkage_is_the_work_of_its_motor) {
  const double torque = 1.5;
  const auto run = turned_by_motor(torque);
  ASSERT_TRUE(run) << run.cause();
  const auto& path = run.trajectory;
  const auto total = path.energies().total;
  for (std::size_t i = 0; i < path.size(); ++i)
    EXPECT_NEAR(total[i] - total[0], torque * (path[i].x[q1] - path[0].x[q1]),
                1e-7 * (total.back() - total[0]));
  EXPECT_LE(std::ranges::max(path.constraint_residuals()), 1e-10);
}

} // namespace
