#include "systems/jet.hpp"

#include <Eigen/Geometry>

namespace hand_written {
namespace {

Matrix3d diagonal(double x, double y, double z) { return Vector3d(x, y, z).asDiagonal(); }

body plane_body(double mass, double inertia, const vector& center, const matrix& turn) {
  return {mass, diagonal(0, 0, inertia), center, turn, Vector3d::Zero(), Vector3d::Zero()};
}

// The point of a body that is currently at `from_center` from its center.
vector velocity_of_point(const body& b, const vector& from_center) {
  return rate_of(b.center) + cross(angular_velocity(b.turn), from_center);
}

} // namespace

// F, T: on the sleigh.
system chaplygin_sleigh(const numbers& p, double F, double T) {
  return {{"q1", "q2", "q3"}, {"u1", "u2", "u3"}, [p, F, T](const jets& q) {
            const matrix A = turn_z(q[2]);
            const vector blade(q[0], q[1], 0.0);
            body sleigh = plane_body(p.at("m"), p.at("I"), blade + p.at("a") * A.col(0), A);
            const Vector3d pull = F * value(A).col(0);
            sleigh.force = pull;
            sleigh.torque = (-p.at("a") * value(A).col(0)).cross(pull) + T * Vector3d::UnitZ();
            const vector v = rate_of(blade);
            const jet aside = dot(v, A.col(1));
            return motion{{sleigh}, {}, {aside}, {dot(v, A.col(0)), aside, rate_of(q[2])}};
          }};
}

// T: the torque of the motor.
system four_bar(const numbers& p, double T) {
  return {{"q1", "q2", "q3"}, {"u1", "u2", "u3"}, [p, T](const jets& q) {
            const matrix A = turn_z(q[0]), B = turn_z(q[0] + q[1]), C = turn_z(q[0] + q[1] + q[2]);
            const vector p1 = p.at("l1") * A.col(0);
            const vector p2 = p1 + p.at("l2") * B.col(0);
            const vector p3 = p2 + p.at("l3") * C.col(0);
            std::vector<body> bodies{plane_body(p.at("m1"), p.at("I1"), p.at("d1") * A.col(0), A),
                                     plane_body(p.at("m2"), p.at("I2"), p1 + p.at("d2") * B.col(0), B),
                                     plane_body(p.at("m3"), p.at("I3"), p2 + p.at("d3") * C.col(0), C)};
            for (body& b : bodies) b.force(1) = -b.mass * p.at("g");
            bodies[0].torque(2) = T;
            return motion{bodies,
                          {p3(0) - jet(p.at("l0")), p3(1)},
                          {rate_of(p3(0)), rate_of(p3(1))},
                          {rate_of(q[0]), rate_of(q[1]), rate_of(q[2])}};
          }};
}

system pendulum_nonminimal(const numbers& p) {
  return {{"q1", "q2"}, {"u1", "u2"}, [p](const jets& q) {
            body bob = plane_body(p.at("m"), 0, vector(q[0], q[1], 0.0), turn_z(0));
            bob.force(0) = p.at("m") * p.at("g");
            const jet from_circle = q[0] * q[0] + q[1] * q[1] - jet(p.at("L") * p.at("L"));
            return motion{{bob}, {from_circle}, {rate_of(from_circle)}, {rate_of(q[0]), rate_of(q[1])}};
          }};
}

// With a = 0 and the inertia of a disc, this is a disc.
namespace {

system rolling(double R, double a, double m, double g, double along, double across) {
  return {{"q1", "q2", "q3", "q4", "q5"}, {"u1", "u2", "u3", "u4", "u5"}, [=](const jets& q) {
            const matrix L = turn_z(q[0]) * turn_x(q[1]);
            const vector down = -R * L.col(2) - fixed(0, 0, a); // from the center to the contact
            const body torus{m,
                             diagonal(across, along, across),
                             vector(q[3], q[4], -down(2)),
                             L * turn_y(q[2]),
                             Vector3d(0, 0, -m * g),
                             Vector3d::Zero()};
            const vector slip = velocity_of_point(torus, down);
            const vector omega = angular_velocity(torus.turn);
            return motion{{torus},
                          {},
                          {slip(0), slip(1)},
                          {dot(omega, L.col(0)), dot(omega, L.col(1)), dot(omega, L.col(2)), rate_of(q[3]),
                           rate_of(q[4])}};
          }};
}

} // namespace

system rolling_disc(const numbers& p) {
  const double m = p.at("m"), r = p.at("r");
  return rolling(r, 0, m, p.at("g"), m * r * r / 2, m * r * r / 4);
}

system rolling_torus(const numbers& p) {
  const double m = p.at("m"), R = p.at("R"), a = p.at("a");
  return rolling(R, a, m, p.at("g"), m * (R * R + 0.75 * a * a), m * (R * R / 2 + 0.625 * a * a));
}

// x, y: the position of the center of the rear wheel; q3, q6: the angles of the wheels.
system bicycle(const numbers& p) {
  const auto in_level_axes = [p](const std::string& part) {
    Matrix3d inertia = diagonal(p.at("I" + part + "11"), p.at("I" + part + "22"), p.at("I" + part + "33"));
    inertia(0, 2) = inertia(2, 0) = p.at("I" + part + "31");
    const Matrix3d level = value(turn_y(-p.at("htangle")));
    return Matrix3d(level * inertia * level.transpose());
  };
  const Matrix3d frame_inertia = in_level_axes("frame"), fork_inertia = in_level_axes("fork");
  return {
      {"q1", "q2", "q4", "q5", "x", "y", "q3", "q6"},
      {"u1", "u2", "u3", "u4", "u5", "u6"},
      [p, frame_inertia, fork_inertia](const jets& q) {
        const matrix upright = turn_z(q[0]) * turn_x(q[1]);
        const matrix frame = upright * turn_y(q[2] + jet(p.at("htangle")));
        const matrix fork = frame * turn_x(q[3]);
        const vector rear(q[4], q[5], p.at("WRrad") * cos(q[1]));
        const vector head = rear + p.at("framelength") * frame.col(2);
        const vector front = head + p.at("forklength") * fork.col(0) + p.at("forkoffset") * fork.col(2);

        const auto at = [&](const vector& from, const matrix& axes, double x, double z) {
          return vector(from + x * axes.col(0) + z * axes.col(2));
        };
        std::vector<body> bodies{
            {p.at("mframe"), frame_inertia, at(rear, frame, -p.at("framecg1"), p.at("framecg3")), frame},
            {p.at("mfork"), fork_inertia, at(head, fork, -p.at("forkcg1"), p.at("forkcg3")), fork},
            {p.at("mwr"), diagonal(p.at("Iwr11"), p.at("Iwr22"), p.at("Iwr11")), rear, frame * turn_y(q[6])},
            {p.at("mwf"), diagonal(p.at("Iwf11"), p.at("Iwf22"), p.at("Iwf11")), front, fork * turn_y(q[7])}};
        for (body& b : bodies) b.force(2) = -b.mass * p.at("g");

        // The lowest point of a wheel lies along the projection of "down" onto its plane.
        const vector axle = fork.col(1);
        const vector projected = axle(2) * axle - fixed(0, 0, 1);
        const vector front_down = p.at("WFrad") / sqrt(dot(projected, projected)) * projected;
        const vector rear_slip = velocity_of_point(bodies[2], -p.at("WRrad") * upright.col(2));
        const vector front_slip = velocity_of_point(bodies[3], front_down);
        return motion{
            bodies,
            {front(2) + front_down(2)},
            {rear_slip(0), rear_slip(1), front_slip(0), front_slip(1), front_slip(2)},
            {rate_of(q[0]), rate_of(q[1]), rate_of(q[6]), rate_of(q[2]), rate_of(q[3]), rate_of(q[7])}};
      }};
}

// x, y: the position of the mass center.
system rattleback(const numbers& p) {
  Matrix3d inertia = diagonal(p.at("Ixx"), p.at("Iyy"), p.at("Izz"));
  inertia(0, 1) = inertia(1, 0) = p.at("Ixy");
  return {{"q1", "q2", "q3", "x", "y"}, {"u1", "u2", "u3"}, [p, inertia](const jets& q) {
            const matrix turn = turn_z(q[0]) * turn_x(q[1]) * turn_y(q[2]);
            // The point at which the gradient of x^2/a^2 + y^2/b^2 + z^2/c^2 points down.
            const vector up(turn(2, 0), turn(2, 1), turn(2, 2));
            const double a = p.at("a"), b = p.at("b"), c = p.at("c");
            const vector stretched(a * a * up(0), b * b * up(1), c * c * up(2));
            const jet size = sqrt(dot(stretched, up));
            const vector contact = turn * (fixed(0, 0, p.at("h")) - vector(1.0 / size * stretched));
            body stone{p.at("m"), inertia, vector(q[3], q[4], -contact(2)), turn};
            const vector omega = angular_velocity(turn);
            stone.force(2) = -p.at("m") * p.at("g");
            stone.torque = -p.at("sigma") * value(omega);
            const vector slip = velocity_of_point(stone, contact);
            return motion{{stone},
                          {},
                          {slip(0), slip(1)},
                          {dot(omega, turn.col(0)), dot(omega, turn.col(1)), dot(omega, turn.col(2))}};
          }};
}

} // namespace hand_written
