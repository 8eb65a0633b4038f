// builds: clang++
// A four-bar linkage described by its joints: the reactions, compared with the Newton-Euler equations of its
// bars, which are solved with the accelerations of the closed loop.
#include <kanexpr/reactions.hpp>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <random>

namespace {

using namespace kanexpr;
using Eigen::Vector2d;

constexpr double ground = 2, length[3]{0.7, 1.8, 1.2}, to_center[3]{0.3, 1.1, 0.5}, mass[3]{1.3, 2.1, 0.9},
                 inertia_of[3]{0.11, 0.62, 0.17}, weight = 9.81;

template <int i>
using bar = body<mass[i], to_center[i] * own::x, inertia<own, 0, 0, inertia_of[i]>>;

struct Ground : inertial_ground<Ground> {};
struct Crank : pin<Crank, Ground, axis<own::z>, bar<0>> {};
struct Coupler : pin<Coupler, Crank, axis<own::z>, at<length[0] * Crank::x>, bar<1>> {};
struct Rocker : pin<Rocker, Coupler, axis<own::z>, at<length[1] * Coupler::x>, bar<2>> {};
struct Tip : offset<Tip, Rocker, length[2] * Rocker::x> {};
struct Bearing : offset<Bearing, Ground, ground * Ground::x> {};
struct Linkage : kane_system<inertial<Ground>, joints<Crank, Coupler, Rocker>,
                             configuration_constraints<coincident<Tip, Bearing, Ground::x, Ground::y>>,
                             dependent<q_of<Coupler>, q_of<Rocker>, u_of<Coupler>, u_of<Rocker>>,
                             loads<gravity<-weight * Ground::y>, motor<Crank>>> {};

Vector2d along(double angle) { return {std::cos(angle), std::sin(angle)}; }
Vector2d across(double angle) { return {-std::sin(angle), std::cos(angle)}; }
double turning(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// The absolute angles and rates of the bars for a given angle of the crank.
struct placed {
  double angle[3], rate[3];
  placed(double crank, double crank_rate) {
    const Vector2d open = ground * Vector2d::UnitX() - length[0] * along(crank);
    const double r = open.norm(),
                 inner = (length[1] * length[1] + r * r - length[2] * length[2]) / (2 * length[1] * r);
    angle[0] = crank, rate[0] = crank_rate;
    angle[1] = std::atan2(open.y(), open.x()) + std::acos(inner);
    const Vector2d last = open - length[1] * along(angle[1]);
    angle[2] = std::atan2(last.y(), last.x());
    const Eigen::Matrix2d closing =
        (Eigen::Matrix2d() << length[1] * across(angle[1]), length[2] * across(angle[2])).finished();
    const Vector2d rates = closing.inverse() * (-length[0] * crank_rate * across(crank));
    rate[1] = rates[0], rate[2] = rates[1];
  }
};

/// Absolute angular accelerations of the bars, the force at the start of each bar, and the force at the end
/// of the last one.
Eigen::Matrix<double, 11, 1> newton_and_euler(const placed& at, double torque) {
  Eigen::Matrix<double, 11, 11> A = Eigen::Matrix<double, 11, 11>::Zero();
  Eigen::Matrix<double, 11, 1> b = Eigen::Matrix<double, 11, 1>::Zero();
  for (int i = 0; i < 3; ++i) {
    // m a = F_begin + F_end + weight, with the accelerations of all preceding bars
    const int begin = 3 + 2 * i, end = begin + 2;
    const double sign = i < 2 ? -1 : 1; // the end of a bar is the start of the next
    b.segment<2>(3 * i) = -mass[i] * weight * Vector2d::UnitY();
    for (int j = 0; j <= i; ++j) {
      const double arm = j < i ? length[j] : to_center[j];
      A.block<2, 1>(3 * i, j) += mass[i] * arm * across(at.angle[j]);
      b.segment<2>(3 * i) += mass[i] * arm * at.rate[j] * at.rate[j] * along(at.angle[j]);
    }
    A.block<2, 2>(3 * i, begin) -= Eigen::Matrix2d::Identity();
    A.block<2, 2>(3 * i, end) -= sign * Eigen::Matrix2d::Identity();
    // I α = r_begin × F_begin + r_end × F_end + T
    const Vector2d r_begin = -to_center[i] * along(at.angle[i]),
                   r_end = (length[i] - to_center[i]) * along(at.angle[i]);
    A(3 * i + 2, i) = inertia_of[i];
    for (int k = 0; k < 2; ++k) {
      A(3 * i + 2, begin + k) = -turning(r_begin, Vector2d::Unit(k));
      A(3 * i + 2, end + k) = -sign * turning(r_end, Vector2d::Unit(k));
    }
    b[3 * i + 2] = i == 0 ? torque : 0;
    // the loop stays closed
    A.block<2, 1>(9, i) = length[i] * across(at.angle[i]);
    b.segment<2>(9) += length[i] * at.rate[i] * at.rate[i] * along(at.angle[i]);
  }
  return A.fullPivLu().solve(b);
}

template <class Bar>
void expect_carried(const state<Linkage>& x, double torque, const Vector2d& force, double angle) {
  const auto found =
      reactions_of<Linkage, Bar>(x, parameter_values<Linkage>(), input_values<Linkage>(torque));
  EXPECT_TRUE(found.status) << found.status.cause();
  const double scale = 1 + force.norm();
  EXPECT_NEAR(found.force.x(), force.dot(along(angle)), 1e-11 * scale);
  EXPECT_NEAR(found.force.y(), force.dot(across(angle)), 1e-11 * scale);
  EXPECT_NEAR(found.force.z(), 0, 1e-11 * scale);
  EXPECT_LT(found.torque.norm(), 1e-11 * scale);
}

TEST(four_bar_by_joints, carries_what_newton_and_euler_say) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(-3, 3);
  for (int repeat = 0; repeat < 20; ++repeat) {
    const placed at(any(random), any(random));
    const double torque = any(random);
    state<Linkage> x;
    x << at.angle[0], at.angle[1] - at.angle[0], at.angle[2] - at.angle[1], at.rate[0],
        at.rate[1] - at.rate[0], at.rate[2] - at.rate[1];
    const Eigen::Matrix<double, 11, 1> hand = newton_and_euler(at, torque);
    using eom = equations_of_motion<Linkage>;
    ASSERT_LT(eom::constraint_residual(x).norm(), 1e-12);
    const auto a = eom::udot(x, parameter_values<Linkage>(), input_values<Linkage>(torque));
    const double scale = 1 + hand.head<3>().norm();
    EXPECT_NEAR(a[0], hand[0], 1e-11 * scale);
    EXPECT_NEAR(a[1], hand[1] - hand[0], 1e-11 * scale);
    EXPECT_NEAR(a[2], hand[2] - hand[1], 1e-11 * scale);
    expect_carried<Crank>(x, torque, hand.segment<2>(3), at.angle[0]);
    expect_carried<Coupler>(x, torque, hand.segment<2>(5), at.angle[1]);
    expect_carried<Rocker>(x, torque, hand.segment<2>(7), at.angle[2]);
  }
}

} // namespace
