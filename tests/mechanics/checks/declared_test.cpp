// builds: clang++
// Declarations of a model, compared with what follows from the rest of the model: angular velocities with
// orientations, points fixed in frames with their positions, inertias with the bodies that have them, gravity
// with possible gravity fields.
#include "mechanics/workbench.hpp"

namespace {

using namespace workbench;

std::string told(bench& b) { return std::string(b.check().view()); }

std::string apart(const std::string& frame) {
  return "the angular velocity of frame " + frame +
         " does not match its orientation, and no omitted angle explains the difference; if this is "
         "intended, write angular_velocity_apart_from_orientation<...>";
}
std::string elsewhere(const std::string& body, const std::string& axes, const std::string& frame) {
  return "the inertia of " + body + " is given along the axes of " + axes + " and changes as seen from " +
         frame + ", the body frame; if this is intended, write changing_inertia<...>";
}

// Yaw, lean and spin with speeds along the leaning axes; a test assigns one of the speeds wrongly.
struct disc : bench {
  frame_id yaw = rotated("Y", n, q[0], along(n, 0, 0, 1)),
           lean = rotated("L", yaw, q[1], along(yaw, 1, 0, 0)),
           spin = rotated("R", lean, q[2], along(lean, 0, 1, 0));

  explicit disc(double factor = 1) : bench(false) {
    angular_velocity(spin, n, along(lean, u[0], number(factor) * u[1], u[2]));
    kinematic_equation(dot(q[0]) - u[2] / cos(q[1]));
    kinematic_equation(dot(q[1]) - u[0]);
    kinematic_equation(dot(q[2]) - u[1] + u[2] * tan(q[1]));
    rigid_body("Disc", o, spin, number(2), inertia(lean, number(1), number(2), number(1)));
  }
};

TEST(angular_velocity, is_that_of_the_orientation) {
  disc right, wrong(2);
  EXPECT_EQ(told(right), "");
  EXPECT_EQ(told(wrong), apart("R"));
}

// Three angles and a quaternion: the kinematic equations are those of one frame, and another frame has the
// same orientation.
TEST(angular_velocity, is_that_of_angles_and_quaternions) {
  for (const bool angles : {true, false})
    for (const double factor : {1.0, 1.5}) {
      SCOPED_TRACE(angles);
      bench b(false);
      const expression last = angles ? b.number(0.0) : b.coordinate("e3");
      const auto frame = [&](const char* called) {
        return angles ? b.body_fixed(called, b.n, "zxy", b.q[0], b.q[1], b.q[2])
                      : b.quaternion(called, b.n, b.q[0], b.q[1], b.q[2], last);
      };
      const frame_id f = frame("F"), g = frame("G");
      b.angular_velocity(f, b.n, b.along(f, b.u[0], b.u[1], b.u[2]));
      b.angular_velocity(g, b.n, b.along(g, b.u[0], b.u[1], b.number(factor) * b.u[2]));
      b.kinematics_of(f, b.n);
      for (const frame_id turns : {f, g})
        b.rigid_body(turns == f ? "One" : "Other", b.o, turns, b.number(2),
                     b.inertia(turns, b.number(1), b.number(2), b.number(2.5)));
      EXPECT_EQ(told(b), factor == 1 ? "" : apart("G"));
    }
}

// A function of time.
TEST(angular_velocity, is_that_of_an_angle_of_time) {
  for (const double rate : {1.0, 1.5}) {
    bench b;
    const frame_id driven = b.rotated("H", b.n, b.time(), b.along(b.n, 0, 0, 1));
    b.angular_velocity(driven, b.n, b.along(b.n, 0, 0, rate));
    EXPECT_EQ(told(b), rate == 1 ? "" : apart("H"));
  }
}

// Two links in a plane; the speeds are absolute, but the kinematic equations are written for relative ones.
TEST(angular_velocity, has_the_speeds_of_the_kinematic_equations) {
  for (const bool right : {true, false}) {
    bench b(false);
    const frame_id a = b.rotated("A", b.n, b.q[0], b.along(b.n, 0, 0, 1)),
                   c = b.rotated("C", a, b.q[1], b.along(a, 0, 0, 1));
    b.angular_velocity(c, b.n, b.along(b.n, b.number(0.0), b.number(0.0), b.u[1]));
    b.kinematic_equation(b.dot(b.q[0]) - b.u[0]);
    b.kinematic_equation(right ? b.dot(b.q[1]) - b.u[1] + b.u[0] : b.dot(b.q[1]) - b.u[1]);
    b.kinematic_equation(b.dot(b.q[2]) - b.u[2]);
    b.particle("Bead", b.offset("P", b.o, b.along(c, b.number(1), b.number(0.0), b.q[2])), b.number(1));
    EXPECT_EQ(told(b), right ? "" : apart("C"));
  }
}

// A wheel without an angle: with its own speed, or rolling, so that a coordinate determines its spin, or as
// the planet of a gear that rotates about the axis of its arm.
TEST(angular_velocity, may_be_a_spin_whose_angle_is_left_out) {
  bench b;
  const frame_id yaw = b.rotated("Y", b.n, b.q[0], b.along(b.n, 0, 0, 1)),
                 lean = b.rotated("L", yaw, b.q[1], b.along(yaw, 1, 0, 0)),
                 wheel = b.rotated("W", lean, b.number(0.0), b.along(lean, 0, 1, 0)),
                 rolling = b.rotated("R", lean, b.number(0.0), b.along(lean, 0, 1, 0)),
                 planet = b.rotated("P", yaw, b.number(0.0), b.along(yaw, 0, 0, 1));
  const expression free = b.speed("spin"), zero = b.number(0.0);
  b.angular_velocity(wheel, lean, b.along(lean, zero, free, zero));
  b.angular_velocity(rolling, lean, b.along(lean, zero, b.u[2] / b.parameter("r"), zero));
  b.angular_velocity(planet, b.n, b.along(b.n, zero, zero, 3 * b.u[0]));
  const auto round = [&](const std::string& called, frame_id with, frame_id axes) {
    b.rigid_body(called, b.o, with, b.number(1), b.inertia(axes, b.number(1), b.number(2), b.number(1)));
  };
  round("Wheel", wheel, wheel), round("Same", wheel, lean), round("Rolling", rolling, lean);
  b.rigid_body("Planet", b.o, planet, b.number(1),
               b.inertia(planet, b.number(1), b.number(1), b.parameter("I")));
  EXPECT_EQ(told(b), "");
  b.rigid_body("Uneven", b.o, wheel, b.number(1), b.inertia(wheel, b.number(1), b.number(2), b.number(3)));
  EXPECT_EQ(told(b), "the inertia of Uneven is not axisymmetric about the spin axis of W, whose angle is "
                     "omitted; if this is intended, write changing_inertia<...>");
}

std::string left_out(const std::string& what, const std::string& axes, const std::string& frame) {
  return what + " is given along the axes of " + axes + " and depends on the omitted angle of " + frame +
         "; give " + frame + " this angle, or write angular_velocity_apart_from_orientation<...>";
}

// A disc with only yaw and lean as coordinates, whose speeds are along the leaning axes. These are not the
// axes of a frame that spins with the disc.
TEST(angular_velocity, may_mix_the_spin_that_is_left_out_with_the_rest) {
  for (const bool own : {false, true})
    for (const double factor : {1.0, 2.0}) {
      bench b(false);
      const frame_id yaw = b.rotated("Y", b.n, b.q[0], b.along(b.n, 0, 0, 1)),
                     lean = b.rotated("L", yaw, b.q[1], b.along(yaw, 1, 0, 0)),
                     disc = own ? lean : b.rotated("R", lean, b.number(0.0), b.along(lean, 0, 1, 0));
      b.angular_velocity(disc, b.n, b.along(lean, b.u[0], b.u[1], b.number(factor) * b.u[2]));
      b.kinematic_equation(b.dot(b.q[0]) - b.u[2] / cos(b.q[1]));
      b.kinematic_equation(b.dot(b.q[1]) - b.u[0]);
      b.kinematic_equation(b.dot(b.q[2]) - b.q[0]);
      b.rigid_body("Disc", b.o, disc, b.number(2), b.inertia(disc, b.number(1), b.number(2), b.number(1)));
      EXPECT_EQ(told(b), factor > 1 ? apart(own ? "L" : "R")
                         : own      ? left_out("the angular velocity of frame L", "L", "L")
                                    : "");
    }
}

// A wheel on an arm, whose angle is omitted, and parts that can be attached to it.
struct wheel : bench {
  frame_id arm = rotated("A", n, q[0], along(n, 0, 0, 1)),
           hub = rotated("W", arm, number(0.0), along(arm, 1, 0, 0));
  point_id end = offset("E", o, along(arm, 0, 2, 0));

  wheel() {
    angular_velocity(hub, arm, along(arm, speed("spin"), number(0.0), number(0.0)));
    rigid_body("Wheel", end, hub, number(1), inertia(hub, number(2), number(1), number(1)));
  }
};

TEST(angle_that_is_left_out, matters_to_what_lies_off_its_axis) {
  const auto with = [](auto more) {
    wheel b;
    more(b);
    return told(b);
  };
  const auto bead = [](wheel& b, const vector& at) {
    b.particle("Bead", b.offset("P", b.end, at), b.number(1));
  };
  EXPECT_EQ(with([&](wheel& b) { bead(b, b.along(b.hub, 3, 0, 0)); }), "");
  EXPECT_EQ(with([&](wheel& b) { bead(b, b.along(b.arm, 0, 1, 3)); }), "");
  EXPECT_EQ(with([&](wheel& b) { bead(b, b.along(b.hub, 3, 0, 1e-6)); }),
            left_out("the offset of point P", "W", "W"));
  EXPECT_EQ(with([&](wheel& b) { b.offset("Mark", b.end, b.along(b.hub, 0, 0, 1)); }), ""); // carries nothing
  // through a point, and a frame that is fixed in the wheel
  EXPECT_EQ(with([&](wheel& b) {
              const frame_id rim = b.rotated("R", b.hub, b.parameter("tilt"), b.along(b.hub, 0, 1, 0));
              const point_id at = b.offset("Rim", b.end, b.along(rim, 1, 0, 0));
              b.force(b.offset("P", at, b.along(b.arm, 1, 0, 0)), b.along(b.n, 1, 0, 0));
            }),
            left_out("the offset of point Rim", "R", "W"));
  // about the same axis, and about a different one
  for (const bool same : {true, false})
    EXPECT_EQ(
        with([&](wheel& b) {
          const frame_id pin = b.rotated("R", b.hub, b.q[1], b.along(b.hub, same ? 1 : 0, same ? 0 : 1, 0));
          b.rigid_body("Pin", b.end, pin, b.number(1), b.inertia(pin, b.number(2), b.number(2), b.number(2)));
        }),
        same ? "" : left_out("the axis of frame R", "W", "W"));
}

TEST(angle_that_is_left_out, matters_to_loads_and_constraints_along_axes_that_turn) {
  const auto with = [](auto more) {
    wheel b;
    more(b, b.along(b.hub, 1, 0, 0), b.along(b.hub, 0, 1, 0));
    return told(b);
  };
  EXPECT_EQ(with([](wheel& b, const vector& along, const vector&) {
              b.force(b.end, along), b.torque(b.hub, along);
              b.velocity_constraint(b.along(b.n, b.u[0], b.u[1], b.u[2]), along);
            }),
            "");
  EXPECT_EQ(with([](wheel& b, const vector&, const vector& across) { b.force(b.end, across); }),
            left_out("a force on E", "W", "W"));
  EXPECT_EQ(with([](wheel& b, const vector&, const vector& across) { b.torque(b.hub, across); }),
            left_out("a torque on W", "W", "W"));
  EXPECT_EQ(with([](wheel& b, const vector&, const vector& across) {
              b.velocity_constraint(b.along(b.n, b.u[0], b.u[1], b.u[2]), across);
            }),
            left_out("a direction of velocity constraint 1", "W", "W"));
  // a velocity does not depend on the axes in which it is written
  EXPECT_EQ(with([](wheel& b, const vector&, const vector&) {
              b.force(b.end, b.along(b.hub, b.number(0.0), -b.u[0], b.u[1]));
            }),
            "");
}

// A pendulum whose angle is missing, and one with a declared spin that it does not have.
TEST(angle_that_is_left_out, is_not_that_of_a_pendulum) {
  for (const bool forgotten : {true, false}) {
    bench b;
    const frame_id a = b.rotated("A", b.n, forgotten ? b.number(0.0) : b.q[0], b.along(b.n, 0, 0, 1));
    const expression zero = b.number(0.0);
    b.angular_velocity(a, b.n, b.along(a, forgotten ? zero : b.u[0], zero, b.u[0]));
    b.particle("Bob", b.offset("P", b.o, b.along(a, 1, 2, 0)), b.number(1));
    EXPECT_EQ(told(b),
              left_out(forgotten ? "the offset of point P" : "the angular velocity of frame A", "A", "A"));
  }
}

// With two separate speeds, only a ball about its center can rotate.
TEST(angle_that_is_left_out, is_not_a_single_one_of_two_speeds) {
  for (const double offset : {0.0, 1.0}) {
    bench b;
    const expression v = b.speed("v"), w = b.speed("w"), zero = b.number(0.0);
    const frame_id arm = b.rotated("A", b.n, b.q[0], b.along(b.n, 0, 0, 1)),
                   ball = b.rotated("B", arm, zero, b.along(arm, 0, 0, 1));
    b.angular_velocity(ball, arm, b.along(arm, w, zero, v));
    b.rigid_body("Ball", b.offset("P", b.o, b.along(ball, 0, 0, offset)), ball, b.number(1),
                 b.inertia(ball, b.number(2), b.number(2), b.number(2)));
    EXPECT_EQ(told(b), offset > 0 ? left_out("the offset of point P", "B", "B") : "");
  }
}

// A ball, none of whose angles matters, in the axes of the surface on which it rolls.
TEST(angular_velocity, may_be_that_of_a_ball) {
  for (const double across : {2.0, 3.0}) {
    bench b;
    const frame_id arm = b.rotated("A", b.n, b.q[0], b.along(b.n, 1, 1, 0)),
                   ball = b.rotated("B", arm, b.number(0.0), b.along(arm, 0, 0, 1));
    b.angular_velocity(ball, b.n, b.along(arm, b.u[1], -b.u[2], b.u[0]));
    b.rigid_body("Ball", b.o, ball, b.number(1), b.inertia(ball, b.number(2), b.number(2), b.number(across)));
    EXPECT_EQ(told(b), across == 2 ? "" : apart("B"));
  }
}

TEST(angular_velocity, may_be_apart_on_purpose) {
  bench b;
  const frame_id a = b.rotated("A", b.n, b.q[0], b.along(b.n, 0, 0, 1));
  b.angular_velocity_apart_from_orientation(a, b.n, b.along(b.n, b.number(0.0), b.number(0.0), 2 * b.u[0]));
  b.rigid_body("Rod", b.o, a, b.number(1), b.inertia(a, b.number(0.0), b.number(1), b.number(1)));
  EXPECT_EQ(told(b), "");
  mechanics::equations e(b.system());
  expect_equal(b.in_ground(mechanics::angular_velocity_of_frame(e.moving(), place(a))),
               Vector3d(0, 0, 2 * b.u_now[0]));
}

std::string moves_in(const std::string& frame, const std::string& point, const std::string& from) {
  return "point " + point + " is fixed in " + frame + ", but its offset from " + from +
         " changes in that frame; if this is intended, write velocity_apart_from_position";
}

// Two rods suspended from a cart, with relative angles.
struct hanging_rods : bench {
  point_id cart = offset("C", o, along(n, q[0], 0, 0));
  frame_id a = rotated("A", n, q[1], along(n, 0, 0, 1)), b = rotated("B", a, q[2], along(a, 0, 0, 1));
  point_id p = offset("P", cart, along(a, 1, 0, 0)), end = offset("Q", p, along(b, 1, 0.5, 0));

  void mass_at(point_id at) { particle("Bob", at, number(1)); }
};

TEST(fixed_point, that_carries_mass_moves_as_it_is_placed) {
  const auto with = [](frame_id hanging_rods::* of_p, frame_id hanging_rods::* of_end, bool is_end_heavy) {
    hanging_rods b;
    if (of_p != nullptr) b.fixed_in(b.p, b.*of_p);
    if (of_end != nullptr) b.fixed_in(b.end, b.*of_end);
    b.mass_at(is_end_heavy ? b.end : b.p);
    return told(b);
  };
  frame_id hanging_rods::*const none = nullptr, hanging_rods::*const n = &hanging_rods::n,
                                hanging_rods::*const a = &hanging_rods::a,
                                hanging_rods::*const b = &hanging_rods::b;
  EXPECT_EQ(with(a, none, false), "");
  EXPECT_EQ(with(a, b, true), "");
  EXPECT_EQ(with(none, b, true), "");
  EXPECT_EQ(with(n, none, false), moves_in("N", "P", "C"));
  EXPECT_EQ(with(b, none, false), moves_in("B", "P", "C"));
  EXPECT_EQ(with(a, a, true), moves_in("A", "Q", "P"));
  EXPECT_EQ(with(none, n, true), moves_in("N", "Q", "P"));
  // on the way to a mass
  EXPECT_EQ(with(n, none, true), moves_in("N", "P", "C"));
  EXPECT_EQ(with(n, b, true), moves_in("N", "P", "C"));
  EXPECT_EQ(with(none, n, false), "");
}

TEST(fixed_point, may_move_apart_on_purpose) {
  hanging_rods b;
  b.velocity_apart_from_position(b.end, b.a, b.along(b.a, 0.0, 0, 0));
  b.mass_at(b.end);
  EXPECT_EQ(told(b), "");
}

// The axes of its offset need not be those of the frame.
TEST(fixed_point, is_placed_along_any_axes) {
  hanging_rods b;
  const point_id above = b.offset("Above", b.p, b.along(b.a, 0, 0, 1));
  b.fixed_in(above, b.b);
  b.mass_at(above);
  EXPECT_EQ(told(b), "");
  const frame_id on = b.rotated("D", b.b, b.number(0.3), b.along(b.b, 1, 0, 0));
  const point_id aside = b.offset("Aside", b.p, b.along(on, 0, 1, 0));
  b.fixed_in(aside, b.b);
  b.particle("Second", aside, b.number(1));
  EXPECT_EQ(told(b), "");
}

// An origin may be the hub of a wheel whose position is omitted, but not if it is placed using an angle that
// the wheel does not have.
TEST(fixed_point, on_the_ground_is_placed_by_the_orientation_of_a_wheel) {
  for (const bool is_wheel : {true, false}) {
    bench b;
    const frame_id lean = b.rotated("L", b.n, b.q[0], b.along(b.n, 1, 0, 0)),
                   wheel =
                       b.rotated("W", is_wheel ? lean : b.n, b.q[1], b.along(is_wheel ? lean : b.n, 0, 1, 0));
    const point_id hub = b.offset("H", b.o, b.along(lean, 0, 0, 0.3));
    b.fixed_in(hub, wheel);
    b.particle("Hub", b.offset("G", hub, b.along(lean, 0, 0, 0.1)), b.number(1));
    EXPECT_EQ(told(b), is_wheel ? "" : moves_in("W", "H", "O"));
  }
}

// A gear rolls on a second one, which is carried by a cart; the arm between them rotates as the teeth
// require, by kinematic equations or by a constraint. The contact point is fixed in either gear.
TEST(fixed_point, may_be_where_two_bodies_touch) {
  for (const bool is_arm_free : {true, false}) {
    bench b(false);
    const point_id cart = b.offset("C", b.o, b.along(b.n, b.q[0], 0, 0));
    const expression turned = is_arm_free ? b.coordinate("q3") : (2 * b.q[1] + b.q[2]) / 3;
    const frame_id sun = b.rotated("S", b.n, b.q[1], b.along(b.n, 0, 0, 1)),
                   planet = b.rotated("P", b.n, b.q[2], b.along(b.n, 0, 0, 1)),
                   arm = b.rotated("A", b.n, turned, b.along(b.n, 0, 0, 1));
    for (int i = 0; i < 3; ++i) b.kinematic_equation(b.dot(b.q[i]) - b.u[i]);
    if (is_arm_free) b.kinematic_equation(b.dot(turned) - b.speed("u3"));
    const point_id tooth = b.offset("T", cart, b.along(arm, 2, 0, 0)),
                   center = b.offset("G", tooth, b.along(arm, 1, 0, 0));
    b.fixed_in(tooth, sun);
    b.fixed_in(center, planet);
    b.particle("Planet", center, b.number(1));
    b.particle("Cart", cart, b.number(1));
    for (const frame_id f : {sun, planet, arm})
      b.rigid_body(f == sun      ? "Sun"
                   : f == planet ? "Wheel"
                                 : "Arm",
                   cart, f, b.number(1), b.inertia(f, b.number(1), b.number(1), b.number(1)));
    EXPECT_EQ(told(b), "");
  }
}

// A tiny part of the rate, of a speed that reaches it through two kinematic equations only.
TEST(declared_velocity, is_the_rate_of_the_position_for_each_speed_alone) {
  for (const double part : {0.0, 1e-10}) {
    bench b(false);
    b.kinematic_equation(b.dot(b.q[0]) + b.dot(b.q[1]) - b.u[0] - b.u[1]);
    b.kinematic_equation(b.dot(b.q[1]) - b.dot(b.q[0]) + b.u[0] - b.u[1] + b.number(part) * b.u[2]);
    b.kinematic_equation(b.dot(b.q[2]) - b.u[2]);
    const point_id p = b.offset("P", b.o, b.along(b.n, b.q[0], 0, 0));
    b.velocity(p, b.n, b.along(b.n, b.u[0], 0, 0));
    b.particle("Bead", p, b.number(1));
    b.particle("Ballast", b.offset("B", b.o, b.along(b.n, 0, b.q[1], b.q[2])), b.number(1));
    EXPECT_EQ(told(b), part == 0 ? ""
                                 : "the velocity of point P is not the rate of its position; if this is "
                                   "intended, write velocity_apart_from_position");
  }
}

TEST(inertia, stays_as_the_body_sees_it) {
  bench b;
  const frame_id a = b.rotated("A", b.n, b.q[0], b.along(b.n, 0, 0, 1)),
                 c = b.rotated("C", a, b.q[1], b.along(a, 1, 0, 0)),
                 fixed = b.rotated("F", c, b.parameter("tilt"), b.along(c, 1, 2, 3));
  const auto with = [&](const std::string& called, frame_id axes, double x, double y, double z) {
    b.rigid_body(called, b.o, c, b.number(1), b.inertia(axes, b.number(x), b.number(y), b.number(z)));
  };
  with("Round", a, 3, 2, 2), with("Own", c, 1, 2, 3), with("Tilted", fixed, 1, 2, 3);
  EXPECT_EQ(told(b), "");
  with("Rotor", a, 1, 2, 3);
  EXPECT_EQ(told(b), elsewhere("Rotor", "A", "C"));
  b.changing_inertia("Rotor");
  EXPECT_EQ(told(b), "");
  // it contains the quantity with which it changes
  b.rigid_body("Driven", b.o, c, b.number(1), b.inertia(a, b.number(1), b.number(2) + b.time(), b.number(3)));
  EXPECT_EQ(told(b), "");
  // rotated as a function of time
  const frame_id driven = b.rotated("T", c, b.time(), b.along(c, 0, 0, 1));
  with("Clock", driven, 1, 2.5, 3);
  EXPECT_EQ(told(b), elsewhere("Clock", "T", "C"));
  b.changing_inertia("Nothing");
  EXPECT_EQ(told(b), "changing_inertia refers to body Nothing, which does not exist");
}

TEST(inertia, is_about_a_point_of_the_body) {
  bench b;
  const frame_id a = b.rotated("A", b.n, b.q[0], b.along(b.n, 0, 0, 1)),
                 c = b.rotated("C", a, b.q[1], b.along(a, 0, 0, 1));
  const point_id elbow = b.offset("E", b.o, b.along(a, 1, 0, 0)),
                 center = b.offset("G", elbow, b.along(c, 0.5, 0, 0));
  const auto about = [&](const std::string& called, point_id p) {
    b.rigid_body(called, center, c, b.number(1), b.inertia(c, b.number(1), b.number(8), b.number(8)), p);
  };
  about("Right", elbow);
  EXPECT_EQ(told(b), "");
  about("Wrong", b.o);
  EXPECT_EQ(told(b), "the inertia of Wrong is given about O, which moves in C, the body frame; if this is "
                     "intended, write changing_inertia<...>");
}

TEST(gravity, is_the_same_in_every_configuration) {
  const auto with = [](auto field) {
    bench b;
    const frame_id a = b.rotated("A", b.n, b.q[0], b.along(b.n, 1, 1, 0));
    b.gravity(field(b, a));
    return told(b);
  };
  const std::string only = "; it may contain only parameters, inputs and time";
  EXPECT_EQ(with([](bench& b, frame_id) {
              return b.along(b.n, b.number(0.0), b.time(), b.parameter("g") * b.input("k"));
            }),
            "");
  EXPECT_EQ(with([](bench& b, frame_id) { return b.along(b.n, b.number(0.0), b.q[1], b.number(1)); }),
            "gravity contains the coordinate q1" + only);
  EXPECT_EQ(with([](bench& b, frame_id) { return b.along(b.n, b.number(0.0), b.u[1], b.number(1)); }),
            "gravity contains the speed u1" + only);
  EXPECT_EQ(with([](bench& b, frame_id) { return b.along(b.n, b.number(0.0), b.dot(b.q[1]), b.number(1)); }),
            "gravity contains the rate of coordinate q1" + only);
  EXPECT_EQ(with([](bench& b, frame_id a) { return b.along(a, 0, 0, -9.81); }),
            "gravity is given along the axes of A, which turn with coordinate q0" + only);
  // along axes that rotate with time, or that do not rotate with what is given along them
  EXPECT_EQ(with([](bench& b, frame_id) {
              return b.along(b.rotated("T", b.n, b.time(), b.along(b.n, 1, 0, 0)), 0, 0, -9.81);
            }),
            "");
  EXPECT_EQ(with([](bench& b, frame_id a) { return b.along(a, -9.81, -9.81, 0); }), "");
}

} // namespace
