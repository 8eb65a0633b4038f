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

namespace driven {

using given::m, given::l, given::J, given::c;
constexpr parameter<"k"> k;
struct Ground : inertial_ground<Ground> {};

#include <docs/guide/joints/driven.cpp>

// (m l² + 50² J) u̇ of a motor at a stop.
TEST(joints, have_stops_and_rotors) {
  expect_no_mistake<System>();
  using eom = equations_of_motion<System>;
  const eom::parameters p{{m, 2}, {l, 0.5}, {J, 1e-3}, {c, 3}, {k, 7}};
  const eom::state x{{q_of<Shoulder>, 2.1}, {u_of<Shoulder>, 0.4}};
  const double torque = 5 - 7 * (2.1 - 0.3) - 3 * 0.4 - 500 * (0.1 - 0.0015) * (1 + 0.5 * 0.4);
  EXPECT_NEAR(eom::udot(x, p, eom::inputs{{effort_of<Shoulder>, 5}})(0), torque / (2 * 0.25 + 2500 * 1e-3),
              1e-10);
}

} // namespace driven

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
