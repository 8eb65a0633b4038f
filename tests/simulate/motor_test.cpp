// A motor that turns a four-bar linkage, whose loop stays closed.
#include <kanexpr/simulate.hpp>

#include <models/four_bar.hpp>

#include <gtest/gtest.h>

#include <algorithm>

namespace {

using namespace kanexpr;
using namespace four_bar;

TEST(energy, of_a_linkage_is_the_work_of_its_motor) {
  const double torque = 1.5;
  const auto run = simulate<System>({{q1, 0.5}, {q2, 0.4}, {q3, -2}, {u1, 7}},
                                    {{l0, 1.0},
                                     {l1, 0.4},
                                     {l2, 1.1},
                                     {l3, 0.8},
                                     {d1, 0.15},
                                     {d2, 0.6},
                                     {d3, 0.35},
                                     {m1, 0.5},
                                     {m2, 1.2},
                                     {m3, 0.9},
                                     {I1, 0.011},
                                     {I2, 0.13},
                                     {I3, 0.05},
                                     {g, 9.81}},
                                    {0, 3},
                                    {.inputs = {{T, torque}},
                                     .relative_tolerance = 1e-10,
                                     .absolute_tolerance = 1e-12,
                                     .output_every = 0.01});
  ASSERT_TRUE(run) << run.cause();
  const auto& path = run.trajectory;
  const auto total = path.energies().total;
  for (std::size_t i = 0; i < path.size(); ++i)
    EXPECT_NEAR(total[i] - total[0], torque * (path[i].x[q1] - path[0].x[q1]),
                1e-7 * (total.back() - total[0]));
  EXPECT_LE(std::ranges::max(path.constraint_residuals()), 1e-10);
}

} // namespace
