// What a model declares against what follows from the rest of it: angular velocities against orientations,
// inertias against the bodies that have them, gravity against the fields that it can be.
#include "workbench.hpp"

namespace {

using namespace workbench;

std::string told(bench& b) { return std::string(b.check().view()); }

std::string apart(const std::string& frame) {
  return "the angular velocity of frame " + frame +
         " is not that of its orientation, and no angle that is left out explains it; if that is meant, "
         "write "
         "angular_velocity_apart_from_orientation<...>";
}
std::string elsewhere(const std::string& body, const std::string& axes, const std::string& frame) {
  return "the inertia of " + body + " is given in axes of " + axes + " and changes as seen from " + frame +
         ", with which the body turns; if that is meant, write changing_inertia<...>";
}

// Yaw, lean and spin with speeds along the axes that lean; a test puts one of the speeds wrong.
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

// Of three angles at once and of a quaternion: the kinematic equations are those of one frame, and another
// stands in the same way.
TEST(angular_velocity, is_that_of_angles_and_quaternions) {
  for (const bool angles : {true, false})
    for (const double factor : {1.0, 1.5}) {
      SCOPED_TRACE(angles);
      bench b(false);
      const expression last = angles ? b.number(0) : b.coordinate("e3");
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

// By the time.
TEST(angular_velocity, is_that_of_an_angle_of_time) {
  for (const double rate : {1.0, 1.5}) {
    bench b;
    const frame_id driven = b.rotated("H", b.n, b.time(), b.along(b.n, 0, 0, 1));
    b.angular_velocity(driven, b.n, b.along(b.n, 0, 0, rate));
    EXPECT_EQ(told(b), rate == 1 ? "" : apart("H"));
  }
}

// Two links in a plane; the speeds are absolute, and the kinematic equations are written for relative ones.
TEST(angular_velocity, has_the_speeds_of_the_kinematic_equations) {
  for (const bool right : {true, false}) {
    bench b(false);
    const frame_id a = b.rotated("A", b.n, b.q[0], b.along(b.n, 0, 0, 1)),
                   c = b.rotated("C", a, b.q[1], b.along(a, 0, 0, 1));
    b.angular_velocity(c, b.n, b.along(b.n, b.number(0), b.number(0), b.u[1]));
    b.kinematic_equation(b.dot(b.q[0]) - b.u[0]);
    b.kinematic_equation(right ? b.dot(b.q[1]) - b.u[1] + b.u[0] : b.dot(b.q[1]) - b.u[1]);
    b.kinematic_equation(b.dot(b.q[2]) - b.u[2]);
    b.particle("Bead", b.offset("P", b.o, b.along(c, b.number(1), b.number(0), b.q[2])), b.number(1));
    EXPECT_EQ(told(b), right ? "" : apart("C"));
  }
}

// A wheel without its angle: with a speed of its own, or rolling, so that a coordinate says how it spins, or
// as the planet of a gear that turns about the axis of its arm.
TEST(angular_velocity, may_be_a_spin_whose_angle_is_left_out) {
  bench b;
  const frame_id yaw = b.rotated("Y", b.n, b.q[0], b.along(b.n, 0, 0, 1)),
                 lean = b.rotated("L", yaw, b.q[1], b.along(yaw, 1, 0, 0)),
                 wheel = b.rotated("W", lean, b.number(0), b.along(lean, 0, 1, 0)),
                 rolling = b.rotated("R", lean, b.number(0), b.along(lean, 0, 1, 0)),
                 planet = b.rotated("P", yaw, b.number(0), b.along(yaw, 0, 0, 1));
  const expression free = b.speed("spin"), zero = b.number(0);
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
  EXPECT_EQ(told(b),
            "the inertia of Uneven is not the same from all sides of the axis about which W turns without "
            "an angle; if that is meant, write changing_inertia<...>");
}

// A disc of which only yaw and lean are coordinates, and its speeds lie along the axes that lean.
TEST(angular_velocity, may_mix_the_spin_that_is_left_out_with_the_rest) {
  for (const double factor : {1.0, 2.0}) {
    bench b(false);
    const frame_id yaw = b.rotated("Y", b.n, b.q[0], b.along(b.n, 0, 0, 1)),
                   lean = b.rotated("L", yaw, b.q[1], b.along(yaw, 1, 0, 0));
    b.angular_velocity(lean, b.n, b.along(lean, b.u[0], b.u[1], b.number(factor) * b.u[2]));
    b.kinematic_equation(b.dot(b.q[0]) - b.u[2] / cos(b.q[1]));
    b.kinematic_equation(b.dot(b.q[1]) - b.u[0]);
    b.kinematic_equation(b.dot(b.q[2]) - b.q[0]);
    b.rigid_body("Disc", b.o, lean, b.number(2), b.inertia(lean, b.number(1), b.number(2), b.number(1)));
    EXPECT_EQ(told(b), factor == 1 ? "" : apart("L"));
  }
}

// A ball, of whose angles none matters, in the axes of what it lies on.
TEST(angular_velocity, may_be_that_of_a_ball) {
  for (const double across : {2.0, 3.0}) {
    bench b;
    const frame_id arm = b.rotated("A", b.n, b.q[0], b.along(b.n, 1, 1, 0)),
                   ball = b.rotated("B", arm, b.number(0), b.along(arm, 0, 0, 1));
    b.angular_velocity(ball, b.n, b.along(arm, b.u[1], -b.u[2], b.u[0]));
    b.rigid_body("Ball", b.o, ball, b.number(1), b.inertia(ball, b.number(2), b.number(2), b.number(across)));
    EXPECT_EQ(told(b), across == 2 ? "" : apart("B"));
  }
}

TEST(angular_velocity, may_be_apart_on_purpose) {
  bench b;
  const frame_id a = b.rotated("A", b.n, b.q[0], b.along(b.n, 0, 0, 1));
  b.angular_velocity_apart_from_orientation(a, b.n, b.along(b.n, b.number(0), b.number(0), 2 * b.u[0]));
  b.rigid_body("Rod", b.o, a, b.number(1), b.inertia(a, b.number(0), b.number(1), b.number(1)));
  EXPECT_EQ(told(b), "");
  mechanics::equations e(b.mechanism());
  expect_equal(b.in_ground(mechanics::angular_velocity_of_frame(e.moving(), place(a))),
               Vector3d(0, 0, 2 * b.u_now[0]));
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
  // what it changes with stands in it
  b.rigid_body("Driven", b.o, c, b.number(1), b.inertia(a, b.number(1), b.number(2) + b.time(), b.number(3)));
  EXPECT_EQ(told(b), "");
  // turned by the time
  const frame_id driven = b.rotated("T", c, b.time(), b.along(c, 0, 0, 1));
  with("Clock", driven, 1, 2.5, 3);
  EXPECT_EQ(told(b), elsewhere("Clock", "T", "C"));
  b.changing_inertia("Nothing");
  EXPECT_EQ(told(b), "the inertia of Nothing is said to change, and there is no such body");
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
  EXPECT_EQ(told(b),
            "the inertia of Wrong is given about O, which moves in C, with which the body turns; if that is "
            "meant, write changing_inertia<...>");
}

TEST(gravity, is_the_same_in_every_configuration) {
  const auto with = [](auto field) {
    bench b;
    const frame_id a = b.rotated("A", b.n, b.q[0], b.along(b.n, 1, 1, 0));
    b.gravity(field(b, a));
    return told(b);
  };
  const std::string only = "; it may hold parameters, inputs and time only";
  EXPECT_EQ(with([](bench& b, frame_id) {
              return b.along(b.n, b.number(0), b.time(), b.parameter("g") * b.input("k"));
            }),
            "");
  EXPECT_EQ(with([](bench& b, frame_id) { return b.along(b.n, b.number(0), b.q[1], b.number(1)); }),
            "gravity holds the coordinate q1" + only);
  EXPECT_EQ(with([](bench& b, frame_id) { return b.along(b.n, b.number(0), b.u[1], b.number(1)); }),
            "gravity holds the speed u1" + only);
  EXPECT_EQ(with([](bench& b, frame_id) { return b.along(b.n, b.number(0), b.dot(b.q[1]), b.number(1)); }),
            "gravity holds the rate of coordinate q1" + only);
  EXPECT_EQ(with([](bench& b, frame_id a) { return b.along(a, 0, 0, -9.81); }),
            "gravity is given along axes of A, which turn with coordinate q0" + only);
  // along axes that turn with the time, or that do not turn with what is along them
  EXPECT_EQ(with([](bench& b, frame_id) {
              return b.along(b.rotated("T", b.n, b.time(), b.along(b.n, 1, 0, 0)), 0, 0, -9.81);
            }),
            "");
  EXPECT_EQ(with([](bench& b, frame_id a) { return b.along(a, -9.81, -9.81, 0); }), "");
}

} // namespace
