// builds: clang++
// The iiwa from a file, compared with the model written by hand: no more operations, and the same results.
#include <iiwa_robot.hpp>

#include <models/iiwa.hpp>

#include <gtest/gtest.h>

namespace {

using namespace kanexpr;
using of_file = equations_of_motion<iiwa_robot::System>;
using by_hand = equations_of_motion<iiwa::System>;

TEST(iiwa_of_a_file, is_the_one_by_hand) {
  static_assert(of_file::cost(of_file::udot).multiplications <= by_hand::cost(by_hand::udot).multiplications);
  static_assert(of_file::cost(of_file::udot).additions <= by_hand::cost(by_hand::udot).additions);
  Eigen::Matrix<double, 14, 1> x;
  Eigen::Matrix<double, 7, 1> r;
  for (int i = 0; i < 14; ++i) x[i] = 0.1 * (i % 5) - 0.3;
  for (int i = 0; i < 7; ++i) r[i] = 3 - i;
  const Eigen::Matrix<double, 7, 1> ours = of_file::udot(x, of_file::parameters(), r),
                                    theirs = by_hand::udot(x, by_hand::parameters(), r);
  EXPECT_TRUE(ours.isApprox(theirs, 1e-14));
}

} // namespace
