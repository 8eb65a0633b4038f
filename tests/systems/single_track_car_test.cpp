// builds: clang++ all
// The linear single-track car: eigenvalues and steady cornering with and without relaxation lengths, compared
// with closed forms. Pacejka (2012), sections 1.3.2 and 7.2.1.
#include <kanexpr/runtime/builder.hpp>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <string>
#include <utility>
#include <vector>

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using kanexpr::derive;
using kanexpr::model;
using kanexpr::runtime::builder;
using kanexpr::runtime::frame_id;
using kanexpr::runtime::point_id;
using kanexpr::runtime::tyre_data;
using kanexpr::symbolic::expression;

// A car on ground that carries it. Its inertia about the vertical contains that of the wheels.
struct car {
  double mass = 1500, inertia = 2400, a = 1.2, b = 1.6, front = 9e4, rear = 1.1e5, radius = 0.3;
  double standstill = 0.05, length_front = 0.4, length_rear = 0.6, trail = 0.03;
};

struct single_track : builder {
  expression x = coordinate("x"), y = coordinate("y"), yaw = coordinate("yaw"), spin_front = coordinate("sf"),
             spin_rear = coordinate("sr"), u = speed("u"), v = speed("v"), r = speed("r"),
             turning_front = speed("wf"), turning_rear = speed("wr"), steer = prescribed("delta");
  frame_id n = inertial_frame(), body{};
  point_id o{}, center{};

  explicit single_track(const car& c, bool relaxes) : builder("N") {
    const expression cosine = cos(yaw), sine = sin(yaw);
    kinematic_equation(dot(x) - (u * cosine - v * sine));
    kinematic_equation(dot(y) - (u * sine + v * cosine));
    kinematic_equation(dot(yaw) - r);
    kinematic_equation(dot(spin_front) - turning_front);
    kinematic_equation(dot(spin_rear) - turning_rear);
    o = origin("O");
    body = rotated("Body", n, yaw, along(n, 0, 0, 1));
    center = offset("Center", o, along(n, x, y, c.radius));
    rigid_body("Car", center, body, number(c.mass), inertia(body, 1500, 2000, c.inertia - 0.5));
    const frame_id fork = rotated("Fork", body, steer, along(body, 0, 0, 1));
    axle("Front", fork, c.a, spin_front, c, c.front, c.length_front, relaxes);
    axle("Rear", body, -c.b, spin_rear, c, c.rear, c.length_rear, relaxes);
  }

private:
  void axle(const std::string& name, frame_id carrier, double ahead, expression angle, const car& c,
            double stiffness, double length, bool relaxes) {
    const frame_id wheel = rotated(name, carrier, angle, along(carrier, 0, 1, 0));
    const point_id hub = offset(name + "Hub", center, along(body, ahead, 0, 0));
    rigid_body(name + "Wheel", hub, wheel, number(1e-9), inertia(wheel, 0.25, 0.5, 0.25));
    tyre_data t = tyre_data::linear(8e4, stiffness);
    t.standstill = c.standstill, t.trail = c.trail;
    if (relaxes) t.relaxation = {0.2, length, state_variable("dx_" + name), state_variable("dy_" + name)};
    tyre(wheel_on_plane({hub, wheel, along(carrier, 0, 1, 0), c.radius}, o, along(n, 0, 0, 1)), t);
  }
};

// A and B of the lateral motion, running straight ahead.
struct lateral_motion {
  MatrixXd A, B;

  lateral_motion(const car& c, double speed, bool relaxes) {
    single_track b(c, relaxes);
    model m = derive(b);
    EXPECT_EQ(m.mistake(), "");
    VectorXd state = VectorXd::Zero(relaxes ? 14 : 10);
    state(5) = speed, state(8) = state(9) = speed / c.radius;
    auto linear = m.linearize().explicit_form();
    auto all_A = m.function(linear.A), all_B = m.function(linear.B);
    const VectorXd inputs = VectorXd::Zero(3);
    const MatrixXd wide = all_A(state, VectorXd(0), inputs), columns = all_B(state, VectorXd(0), inputs);
    const std::vector<Index> kept = relaxes ? std::vector<Index>{6, 7, 11, 13} : std::vector<Index>{6, 7};
    A = wide(kept, kept), B = columns(kept, 0);
  }
};

// The eigenvalues, sorted.
std::vector<std::complex<double>> eigenvalues(const MatrixXd& a) {
  const Eigen::VectorXcd all = Eigen::EigenSolver<MatrixXd>(a).eigenvalues();
  std::vector<std::complex<double>> sorted(all.begin(), all.end());
  std::sort(sorted.begin(), sorted.end(), [](const auto& first, const auto& second) {
    return std::pair(first.real(), first.imag()) < std::pair(second.real(), second.imag());
  });
  return sorted;
}

TEST(single_track_car, has_the_eigenvalues_of_the_closed_form) {
  for (const double speed : {3.0, 20.0, 60.0}) {
    const car c;
    const lateral_motion motion(c, speed, false);
    // the trail moves the forces backward, but not the places of the slips
    const double d = std::hypot(speed, c.standstill), front_arm = c.a - c.trail, rear_arm = c.b + c.trail;
    const double vv = -(c.front + c.rear) / (c.mass * d);
    const double vr = -speed - (c.a * c.front - c.b * c.rear) / (c.mass * d);
    const double rv = -(front_arm * c.front - rear_arm * c.rear) / (c.inertia * d);
    const double rr = -(front_arm * c.a * c.front + rear_arm * c.b * c.rear) / (c.inertia * d);
    const std::complex<double> root = std::sqrt(std::complex<double>((vv - rr) * (vv - rr) / 4 + vr * rv));
    const std::complex<double> middle = (vv + rr) / 2;
    const auto found = eigenvalues(motion.A);
    for (const std::complex<double> expected : {middle - root, middle + root})
      EXPECT_LT(std::min(std::abs(found[0] - expected), std::abs(found[1] - expected)),
                1e-10 * std::abs(expected))
          << speed;
  }
}

// The slips are rounded at standstill: they are a little smaller, or larger with relaxation lengths.
TEST(single_track_car, corners_steadily_with_its_understeer_gradient) {
  car c;
  c.trail = 0;
  const double base = c.a + c.b, speed = 25;
  for (const bool relaxes : {false, true}) {
    const lateral_motion motion(c, speed, relaxes);
    const double rounding = speed / std::hypot(speed, c.standstill),
                 slower = relaxes ? 1 / rounding : rounding;
    const double gradient = c.mass / base * (c.b / c.front - c.a / c.rear) / slower;
    const VectorXd response = -motion.A.partialPivLu().solve(motion.B);
    const double yaw_rate = speed / (base + gradient * speed * speed);
    EXPECT_NEAR(response(1), yaw_rate, 1e-10 * yaw_rate);
    const double sideslip =
        c.b / speed * yaw_rate - c.mass * c.a * speed * yaw_rate / (base * c.rear * slower);
    EXPECT_NEAR(response(0) / speed, sideslip, 1e-10 * std::abs(sideslip));
  }
}

TEST(single_track_car, has_the_eigenvalues_of_the_closed_form_with_relaxation_lengths) {
  for (const double speed : {3.0, 20.0, 60.0}) {
    const car c;
    const lateral_motion motion(c, speed, true);
    const double passing = speed * speed / std::hypot(speed, c.standstill);
    const double front = c.front / c.length_front, rear = c.rear / c.length_rear;
    MatrixXd expected(4, 4);
    expected << 0, -speed, front / c.mass, rear / c.mass,                               //
        0, 0, (c.a - c.trail) * front / c.inertia, -(c.b + c.trail) * rear / c.inertia, //
        -1, -c.a, -passing / c.length_front, 0,                                         //
        -1, c.b, 0, -passing / c.length_rear;
    const auto found = eigenvalues(motion.A), wanted = eigenvalues(expected);
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_LT(std::abs(found[i] - wanted[i]), 1e-10 * std::abs(wanted[i])) << speed;
  }
}

} // namespace
