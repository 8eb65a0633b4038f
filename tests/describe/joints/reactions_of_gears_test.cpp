// builds: clang++ sanitize all
// Reactions of joints whose coordinates and speeds are constrained by gears, belts, racks and equations,
// driven by springs, and shared with other bodies, compared with the Newton-Euler equations.
#include "describe/joints/newton_euler.hpp"

#include <random>

namespace {

using namespace by_hand;

/// The load at a joint, and the part of it that the joint carries.
struct shares {
  wrench all, carried;
  Vector3d force_beside() const { return all.force - carried.force; }
  Vector3d torque_beside() const { return all.torque - carried.torque; }
};

constexpr double rounding = 1e-11;

/// The joints of a system, all released in one call, at random states.
template <class System>
class in_motion : public testing::Test {
protected:
  double any() { return between_(draw_); }

  template <class Freed>
  Eigen::VectorXd carried() const {
    static auto model = derive<Freed>();
    return model.function(model.noncontributing_forces())(x, p, r);
  }
  template <class Freed, int place, class Link, class Seat, class... Outward>
  shares shares_of() const {
    const Eigen::VectorXd all = carried<Freed>();
    return {needed_at<System, Link, Seat, Outward...>(x, p, r),
            {all.segment<3>(6 * place), all.segment<3>(6 * place + 3)}};
  }
  Eigen::VectorXd multipliers() const {
    static auto model = derive<System>();
    return model.function(model.multipliers())(x, p, r);
  }

  state<System> x;
  parameter_values<System> p;
  input_values<System> r;

private:
  std::mt19937 draw_{7};
  std::uniform_real_distribution<double> between_{-1, 1};
};

void expect_along(const Vector3d& axis, const Vector3d& given) {
  EXPECT_LT(given.cross(axis).norm(), rounding * axis.norm());
}
void expect_across(const Vector3d& axis, const Vector3d& given) {
  EXPECT_LT(std::abs(given.dot(axis)), rounding * axis.norm());
}

// A gear train on an arm: a wheel in mesh with the ground, a rack along the arm and a pulley next to it.
struct Arm : pin<Arm, Ground, axis<own::z>, seat, load> {};
struct Wheel
    : pin<Wheel, Arm, axis<own::x + 0.5 * own::z>, home<0.4, Arm::y>, at<0.3 * Arm::y, 0.2 * own::z>, load> {
};
struct Rack : prismatic<Rack, Arm, axis<Arm::x + Arm::y>, at<0.1 * Arm::z>, load> {};
struct Pulley : pin<Pulley, Arm, axis<own::y>, at<0.2 * Arm::x - 0.1 * Arm::z>, load> {};
struct Train : kane_system<inertial<Ground>, joints<Arm, Wheel, Rack, Pulley>,
                           configuration_constraints<gear<Wheel, Arm, -2>, rack_and_pinion<Rack, Wheel, 0.3>,
                                                     belt<Pulley, Wheel, 0.2, 0.5>>,
                           loads<weight, motor<Pulley>, torsional_spring<q_of<Wheel>, 3.0>>> {};
struct Arm_seat : offset<Arm_seat, Arm, 0.4 * Arm::x - 0.1 * Arm::y> {};
struct Wheel_seat : offset<Wheel_seat, Wheel, 0.2 * Wheel::z> {};
struct Freed_train : extended<Train, reactions<Arm, Wheel, Rack, Pulley>> {};

struct gears : in_motion<Train> {
  void draw() {
    const double q = any(), u = any();
    x << q, -2 * q, -0.6 * q, -5 * q, u, -2 * u, -0.6 * u, -5 * u;
    r << 1.3;
  }
};

TEST_F(gears, exert_what_the_joints_do_not_carry) {
  for (int i = 0; i < 5; ++i) {
    draw();
    const Eigen::VectorXd of = multipliers();

    const shares arm = shares_of<Freed_train, 0, Arm, Arm_seat, Wheel, Rack, Pulley>();
    EXPECT_LT(arm.force_beside().norm(), rounding);
    EXPECT_LT((arm.torque_beside() - 2 * of[0] * Vector3d::UnitZ()).norm(), rounding);
    expect_across(Vector3d::UnitZ(), arm.carried.torque);

    const shares wheel = shares_of<Freed_train, 1, Wheel, Wheel_seat>();
    const Vector3d axle = Vector3d(1, 0, 0.5).normalized();
    const double torque = of[0] - 0.3 * of[1] - 0.5 * of[2] - 3 * x[q_of<Wheel>];
    EXPECT_LT(wheel.force_beside().norm(), rounding);
    EXPECT_LT((wheel.torque_beside() - torque * axle).norm(), rounding);
    expect_across(axle, wheel.carried.torque);

    const shares rack = shares_of<Freed_train, 2, Rack, Rack>();
    const Vector3d rail = Vector3d(1, 1, 0).normalized();
    EXPECT_LT((rack.force_beside() - of[1] * rail).norm(), rounding);
    EXPECT_LT(rack.torque_beside().norm(), rounding);
    expect_across(rail, rack.carried.force);

    const shares pulley = shares_of<Freed_train, 3, Pulley, Pulley>();
    EXPECT_LT(pulley.force_beside().norm(), rounding);
    EXPECT_LT((pulley.torque_beside() - (0.2 * of[2] + r[0]) * Vector3d::UnitY()).norm(), rounding);
    expect_across(Vector3d::UnitY(), pulley.carried.torque);
  }
}

TEST_F(gears, leave_to_a_joint_alone_what_it_carries_beside_others) {
  draw();
  const auto alone = reactions_of<Train, Wheel>(x, p, r);
  const Eigen::VectorXd all = carried<Freed_train>();
  EXPECT_LT((all.segment<3>(6) - alone.force).norm(), rounding);
  EXPECT_LT((all.segment<3>(9) - alone.torque).norm(), rounding);
}

// Joints of all other kinds, constrained by equations.
struct Post : cylindrical<Post, Ground, axis<own::z>, seat, load> {};
struct Hook
    : universal<Hook, Post, axis<own::x + 0.3 * own::z, own::z>, at<0.1 * Post::z, 0.2 * own::x>, load> {};
struct Nut
    : screw<Nut, Post, axis<0.2 * own::x + own::y>, pitch<0.1>, at<0.3 * Post::x>, home<0.5, Post::x>, load> {
};
struct Puck : planar<Puck, Post, axis<own::x, own::y + own::z>, at<-0.2 * Post::x>, load> {};
struct Ball : spherical<Ball, Puck, angles<"zxz">, at<0.1 * Puck::y>, load> {};
struct Coupled
    : kane_system<inertial<Ground>, joints<Post, Hook, Nut, Puck, Ball>,
                  configuration_constraints<q_of<Post, 2> == 0.3 * sin(q_of<Post, 1>),
                                            q_of<Hook, 1> == 0.5 * q_of<Nut>,
                                            q_of<Puck, 2> == 0.2 * q_of<Puck, 1> - 0.4 * q_of<Puck, 3>>,
                  velocity_constraints<u_of<Ball, 1> == 0.7 * u_of<Hook, 2> + u_of<Puck, 1>>, loads<weight>> {
};
struct Hook_seat : offset<Hook_seat, Hook, 0.2 * Hook::x> {};
struct Post_seat : offset<Post_seat, Post, 0.4 * Post::x - 0.1 * Post::y> {};
struct Freed_coupled : extended<Coupled, reactions<Post, Hook, Nut, Puck, Ball>> {};

struct equations : in_motion<Coupled> {
  void draw() {
    for (double& value : x) value = any();
    const auto q = [&](auto symbol) -> double& { return x[symbol]; };
    q(q_of<Post, 2>) = 0.3 * std::sin(q(q_of<Post, 1>));
    q(u_of<Post, 2>) = 0.3 * std::cos(q(q_of<Post, 1>)) * q(u_of<Post, 1>);
    q(q_of<Hook, 1>) = 0.5 * q(q_of<Nut>);
    q(u_of<Hook, 1>) = 0.5 * q(u_of<Nut>);
    q(q_of<Puck, 2>) = 0.2 * q(q_of<Puck, 1>) - 0.4 * q(q_of<Puck, 3>);
    q(u_of<Puck, 2>) = 0.2 * q(u_of<Puck, 1>) - 0.4 * q(u_of<Puck, 3>);
    q(u_of<Ball, 1>) = 0.7 * q(u_of<Hook, 2>) + q(u_of<Puck, 1>);
  }
};

TEST_F(equations, exert_along_the_free_ways_of_the_joints_what_these_do_not_carry) {
  for (int i = 0; i < 5; ++i) {
    draw();
    const Vector3d up = Vector3d::UnitZ();
    const shares post = shares_of<Freed_coupled, 0, Post, Post_seat, Hook, Nut, Puck, Ball>();
    expect_along(up, post.force_beside());
    expect_along(up, post.torque_beside());
    expect_across(up, post.carried.force);
    expect_across(up, post.carried.torque);

    const auto [axis, hook_x, hook_y, hook_z] =
        seen<Coupled, Post::x + 0.3 * Post::z, Hook::x, Hook::y, Hook::z>(x);
    const Vector3d first(axis.dot(hook_x), axis.dot(hook_y), axis.dot(hook_z));
    const shares hook = shares_of<Freed_coupled, 1, Hook, Hook_seat>();
    EXPECT_LT(hook.force_beside().norm(), rounding);
    expect_across(first.cross(up), hook.torque_beside());
    expect_across(first, hook.carried.torque);
    expect_across(up, hook.carried.torque);

    const Vector3d thread = Vector3d(0.2, 1, 0).normalized();
    const shares nut = shares_of<Freed_coupled, 2, Nut, Nut>();
    EXPECT_LT(nut.force_beside().norm(), rounding);
    expect_along(thread, nut.torque_beside());
    expect_across(thread, nut.carried.torque + 0.1 * nut.carried.force);

    const Vector3d normal(0, -1, 1);
    const shares puck = shares_of<Freed_coupled, 3, Puck, Puck, Ball>();
    expect_across(normal, puck.force_beside());
    expect_along(normal, puck.torque_beside());
    expect_along(normal, puck.carried.force);
    expect_across(normal, puck.carried.torque);

    const shares ball = shares_of<Freed_coupled, 4, Ball, Ball>();
    EXPECT_LT(ball.force_beside().norm(), rounding);
    EXPECT_LT(ball.carried.torque.norm(), rounding);
  }
}

// A drum that rotates relative to an arm, and a bob on a rope that it unwinds, as a function of the angle of
// the arm.
struct Drum : rotated<Drum, Ground, -3 * q_of<Arm>, Ground::y> {};
struct Drum_body : rigid_body<Drum_body, Ground, Drum, 2.0, inertia<Drum, 0.2, 0.3, 0.2>> {};
struct Bob_at : offset<Bob_at, Ground, 0.5 * q_of<Arm> * Ground::z> {};
struct Bob : particle<Bob, Bob_at, 1.5> {};
struct Shared : kane_system<inertial<Ground>, joints<Arm>, bodies<Drum_body, Bob>,
                            loads<weight, potential_energy<2 * cos(q_of<Arm>)>>> {};
struct Freed_shared : extended<Shared, reactions<Arm>> {};

using shared_coordinates = in_motion<Shared>;

TEST_F(shared_coordinates, load_no_joint_along_its_free_ways) {
  for (double& value : x) value = any();
  const shares arm = shares_of<Freed_shared, 0, Arm, Arm_seat>();
  EXPECT_LT(arm.force_beside().norm(), rounding);
  expect_along(Vector3d::UnitZ(), arm.torque_beside());
  expect_across(Vector3d::UnitZ(), arm.carried.torque);
  EXPECT_GT(arm.torque_beside().norm(), 0.1);
}

} // namespace
