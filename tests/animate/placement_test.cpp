// builds: clang++
#include <kanexpr/animate/camera.hpp>

#include <gtest/gtest.h>

#include <random>

namespace {

using kanexpr::animate::about_axis;

class placement : public testing::Test {
protected:
  Eigen::Matrix3d any_axes() {
    return Eigen::Quaterniond(any_(dice_), any_(dice_), any_(dice_), any_(dice_)).normalized().matrix();
  }
  Eigen::Vector3d any_vector() { return {any_(dice_), any_(dice_), any_(dice_)}; }

private:
  std::mt19937 dice_{7};
  std::normal_distribution<double> any_;
};

void expect_rotation(const Eigen::Matrix3d& r) {
  EXPECT_LT((r.transpose() * r - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff(), 1e-14);
  EXPECT_NEAR(r.determinant(), 1, 1e-14);
}

TEST_F(placement, about_any_axis_is_a_rotation_that_holds_it) {
  for (int i = 0; i < 500; ++i) {
    const Eigen::Matrix3d frame = any_axes();
    const Eigen::Vector3d axis = any_vector();
    const Eigen::Matrix3d r = about_axis(axis, frame.col(0), frame.col(1));
    expect_rotation(r);
    EXPECT_LT((r.col(2) - axis.normalized()).norm(), 1e-14);
  }
}

TEST_F(placement, about_an_axis_of_the_frame_is_a_rotation) {
  const Eigen::Matrix3d frame = any_axes();
  for (int i = 0; i < 3; ++i)
    for (double sign : {1.0, -1.0})
      expect_rotation(about_axis(sign * frame.col(i), frame.col(0), frame.col(1)));
}

TEST_F(placement, turns_with_the_frame) {
  for (int i = 0; i < 100; ++i) {
    const Eigen::Matrix3d frame = any_axes(), turn = any_axes(), turned = turn * frame;
    const Eigen::Vector3d axis = any_vector();
    const Eigen::Matrix3d before = about_axis(axis, frame.col(0), frame.col(1));
    const Eigen::Matrix3d after = about_axis(turn * axis, turned.col(0), turned.col(1));
    EXPECT_LT((turn * before - after).cwiseAbs().maxCoeff(), 1e-13);
  }
}

} // namespace
