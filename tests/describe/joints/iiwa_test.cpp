// builds: clang++
#include <models/iiwa.hpp>
#include <models/iiwa_by_joints.hpp>

#include <gtest/gtest.h>

// The arm of the examples, described by joints and by frames and points.
namespace {

using namespace kanexpr;

// The links of the example, with each motor as one torque between two links.
struct By_hand
    : kane_system<
          inertial<iiwa::N>,
          coordinates<iiwa::q<1>, iiwa::q<2>, iiwa::q<3>, iiwa::q<4>, iiwa::q<5>, iiwa::q<6>, iiwa::q<7>>,
          speeds<iiwa::u<1>, iiwa::u<2>, iiwa::u<3>, iiwa::u<4>, iiwa::u<5>, iiwa::u<6>, iiwa::u<7>>,
          kinematics<simple>,
          bodies<iiwa::Link1_body, iiwa::Link2_body, iiwa::Link3_body, iiwa::Link4_body, iiwa::Link5_body,
                 iiwa::Link6_body, iiwa::Link7_body>,
          loads<gravity<-9.81 * iiwa::N::z>,
                torque_between<iiwa::Link1, iiwa::N, iiwa::T<1> * iiwa::Link1::z>,
                torque_between<iiwa::Link2, iiwa::Link1, iiwa::T<2> * iiwa::Link2::z>,
                torque_between<iiwa::Link3, iiwa::Link2, iiwa::T<3> * iiwa::Link3::z>,
                torque_between<iiwa::Link4, iiwa::Link3, iiwa::T<4> * iiwa::Link4::z>,
                torque_between<iiwa::Link5, iiwa::Link4, iiwa::T<5> * iiwa::Link5::z>,
                torque_between<iiwa::Link6, iiwa::Link5, iiwa::T<6> * iiwa::Link6::z>,
                torque_between<iiwa::Link7, iiwa::Link6, iiwa::T<7> * iiwa::Link7::z>>> {};

using eom = equations_of_motion<iiwa_by_joints::System>;
using hand = equations_of_motion<By_hand>;
using example = equations_of_motion<iiwa::System>;

constexpr bool same_cost(const symbolic::cost& a, const symbolic::cost& b) {
  return a.multiplications == b.multiplications && a.additions == b.additions && a.divisions == b.divisions &&
         a.trigonometric == b.trigonometric && a.nodes == b.nodes;
}
static_assert(same_cost(eom::cost(eom::udot), hand::cost(hand::udot)));
static_assert(same_cost(eom::cost(eom::mass_matrix), hand::cost(hand::mass_matrix)));
static_assert(same_cost(eom::cost(eom::mass_matrix), example::cost(example::mass_matrix)));
static_assert(eom::cost(eom::udot).multiplications == example::cost(example::udot).multiplications);
static_assert(eom::cost(eom::udot).additions <= example::cost(example::udot).additions);

TEST(iiwa_by_joints, moves_as_by_hand_to_the_last_bit) {
  Eigen::Matrix<double, 14, 1> x = Eigen::Matrix<double, 14, 1>::LinSpaced(-1.7, 2.6);
  const Eigen::Matrix<double, 7, 1> T = Eigen::Matrix<double, 7, 1>::LinSpaced(-40, 25);
  for (int i = 0; i < 20; ++i) {
    x = (1.7 * x.array() + 0.3).sin() * 3;
    const auto a = eom::udot(state<iiwa_by_joints::System>(x), parameter_values<iiwa_by_joints::System>(),
                             input_values<iiwa_by_joints::System>(T));
    const auto b = hand::udot(state<By_hand>(x), parameter_values<By_hand>(), input_values<By_hand>(T));
    const auto c = example::udot(state<iiwa::System>(x), parameter_values<iiwa::System>(),
                                 input_values<iiwa::System>(T));
    for (int j = 0; j < 7; ++j) {
      EXPECT_EQ(a[j], b[j]);
      EXPECT_NEAR(a[j], c[j], 1e-11 * c.norm());
    }
  }
}

} // namespace
