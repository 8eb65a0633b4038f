// Joints: docs/guide/joints.md.
#include "docs/no_mistake.hpp"

#include <docs/guide/joints/reactions_header.cpp>

namespace {

using namespace kanexpr;

using docs::expect_no_mistake;

// Declarations that the snippets use.
namespace given {

constexpr coordinate<"q1"> q1;
constexpr coordinate<"q2"> q2;
constexpr coordinate<"s"> s;
constexpr speed<"u1"> u1;
constexpr speed<"u2"> u2;
constexpr speed<"v"> v;
constexpr parameter<"m"> m;
constexpr parameter<"l"> l;
constexpr parameter<"r"> r;
constexpr parameter<"g"> g;
constexpr parameter<"c"> c;
constexpr parameter<"I"> I;
constexpr parameter<"J"> J;
constexpr input<"F"> F;

} // namespace given

namespace arm {

#include <docs/guide/joints/arm.cpp>

TEST(joints, are_an_arm) {
#include <docs/guide/joints/arm_moves.cpp>
  expect_no_mistake<System>();
  EXPECT_EQ(symbolic::print(derive<System>().qdot()), "[u_Upper]\n[u_Lower]");
#include <docs/guide/joints/reactions.cpp>
  EXPECT_NEAR(torque.y(), 0, 1e-12);
  EXPECT_GT(force.norm(), 1);
  EXPECT_TRUE(a.allFinite());
}

} // namespace arm

namespace crane {

using namespace given;

#include <docs/guide/joints/crane.cpp>

TEST(joints, mix_with_frames_and_points) {
  expect_no_mistake<System>();
  EXPECT_EQ((derive<System, position_of<Rope_end, O>>().mistake()), "");
}

} // namespace crane

namespace chain {

using namespace given;

struct Ground : inertial_ground<Ground> {};

template <int i>
struct Link;

#include <docs/guide/joints/chain.cpp>

TEST(joints, are_a_chain) { expect_no_mistake<Chain>(); }

} // namespace chain

namespace simple_kinematics {

using namespace given;

struct N : inertial_frame<N> {};
struct O : origin<O, N> {};
struct P : offset<P, O, q1 * N::x + q2 * N::y> {};
struct Bob : particle<Bob, P, m> {};

#include <docs/guide/joints/simple.cpp>

TEST(joints, need_no_kinematic_equations) {
  expect_no_mistake<Pendulum>();
  EXPECT_EQ(symbolic::print(derive<Pendulum>().qdot()), "[u1]\n[u2]");
}

} // namespace simple_kinematics

namespace wheel {

using namespace given;

struct Ground : inertial_ground<Ground> {};

#include <docs/guide/joints/wheel.cpp>

TEST(joints, roll) { expect_no_mistake<Rolling>(); }

} // namespace wheel

} // namespace
