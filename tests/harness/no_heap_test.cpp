// builds: sanitize
#include "no_heap.hpp"

#include <Eigen/Core>
#include <gtest/gtest.h>

#include <vector>

namespace {

// Global, because a compiler may omit memory whose contents are never read.
std::vector<double> kept;
Eigen::VectorXd kept_by_eigen;
Eigen::Matrix3d fixed = Eigen::Matrix3d::Identity();

TEST(no_heap, fixed_size_work_is_free_of_it) {
  no_heap::guard guard;
  fixed = (fixed * fixed.transpose()).eval();
}

TEST(no_heap, sees_new) {
  EXPECT_EQ(no_heap::allocations_in([] { kept.assign(7, 0.5); }), 1u);
}

TEST(no_heap, sees_eigen) {
  EXPECT_EQ(no_heap::allocations_in([] { kept_by_eigen.setConstant(7, 0.5); }), 1u);
}

TEST(no_heap_death, ends_the_program_under_a_guard) {
  EXPECT_DEATH(
      {
        no_heap::guard guard;
        kept.assign(1000, 0.5);
      },
      "no_heap::guard");
}

} // namespace
