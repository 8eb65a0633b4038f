// builds: clang++ sanitize
// The quaternions whose norm 1 the kinematic differential equations preserve.
#include <kanexpr/mechanics/motion/generic_states.hpp>
#include <kanexpr/mechanics/motion/unit_quaternions.hpp>
#include <kanexpr/runtime/builder.hpp>

#include <gtest/gtest.h>

#include <vector>

namespace {

using kanexpr::runtime::builder;
using kanexpr::runtime::frame_id;
using kanexpr::symbolic::expression;

struct turning_body : builder {
  std::vector<expression> e, u;
  frame_id n = inertial_frame(), body;

  explicit turning_body(int speeds = 3) : builder("N") {
    for (const char* name : {"e0", "e1", "e2", "e3"}) e.push_back(coordinate(name));
    for (const char* name : {"u0", "u1", "u2", "u3"})
      if (static_cast<int>(u.size()) < speeds) u.push_back(speed(name));
    body = quaternion("B", n, e[0], e[1], e[2], e[3]);
  }
  void declare() { angular_velocity(body, n, along(body, u[0], u[1], u[2])); }

  // By the numbers of their coordinates
  std::vector<std::vector<int>> kept() const {
    std::vector<std::vector<int>> all;
    for (const auto& places : kanexpr::mechanics::unit_quaternions(mechanism()))
      all.emplace_back(places.begin(), places.end());
    return all;
  }
};

using numbers = std::vector<std::vector<int>>;
const numbers all_four{{0, 1, 2, 3}}, none;

TEST(unit_quaternions, are_kept_by_the_equations_of_the_library) {
  turning_body b;
  b.declare();
  b.kinematics_of(b.body, b.n);
  EXPECT_EQ(b.kept(), all_four);
}

TEST(unit_quaternions, are_kept_by_equations_that_have_to_be_solved) {
  turning_body b;
  const auto& e = b.e;
  const expression d0 = b.dot(e[0]), d1 = b.dot(e[1]), d2 = b.dot(e[2]), d3 = b.dot(e[3]);
  b.kinematic_equation(b.u[0] - 2 * (e[0] * d1 - e[1] * d0 - e[2] * d3 + e[3] * d2));
  b.kinematic_equation(b.u[1] - 2 * (e[0] * d2 - e[2] * d0 - e[3] * d1 + e[1] * d3));
  b.kinematic_equation(b.u[2] - 2 * (e[0] * d3 - e[3] * d0 - e[1] * d2 + e[2] * d1));
  b.kinematic_equation(e[0] * d0 + e[1] * d1 + e[2] * d2 + e[3] * d3);
  EXPECT_EQ(b.kept(), all_four);
}

TEST(unit_quaternions, are_kept_by_equations_that_hold_other_rates) {
  turning_body b;
  const expression q = b.coordinate("q"), v = b.speed("v");
  const frame_id table = b.rotated("A", b.n, q, b.along(b.n, 0, 0, 1));
  const expression f0 = b.coordinate("f0"), f3 = b.coordinate("f3"), w = b.speed("w"), zero = b.number(0.0);
  const frame_id top = b.quaternion("C", table, f0, zero, zero, f3);
  b.angular_velocity(top, b.n, b.along(top, zero, zero, w));
  b.declare();
  b.kinematics_of(b.body, b.n);
  b.kinematic_equation(b.dot(q) - v);
  b.kinematic_equation(b.dot(f0) + f3 * (w - b.dot(q)) / 2);
  b.kinematic_equation(b.dot(f3) - f0 * (w - b.dot(q)) / 2);
  EXPECT_EQ(b.kept(), (numbers{{0, 1, 2, 3}, {5, 6}}));
}

TEST(unit_quaternions, are_not_kept_where_speeds_are_their_rates) {
  turning_body b(4);
  for (std::size_t i = 0; i < 4; ++i) b.kinematic_equation(b.dot(b.e[i]) - b.u[i]);
  EXPECT_EQ(b.kept(), none);
}

TEST(unit_quaternions, are_not_kept_by_a_wrong_sign) {
  turning_body b;
  const auto& e = b.e;
  const auto& u = b.u;
  b.kinematic_equation(b.dot(e[0]) - (e[1] * u[0] + e[2] * u[1] + e[3] * u[2]) / 2);
  b.kinematic_equation(b.dot(e[1]) - (e[0] * u[0] + e[2] * u[2] - e[3] * u[1]) / 2);
  b.kinematic_equation(b.dot(e[2]) - (e[0] * u[1] + e[3] * u[0] - e[1] * u[2]) / 2);
  b.kinematic_equation(b.dot(e[3]) - (e[0] * u[2] + e[1] * u[1] - e[2] * u[0]) / 2);
  EXPECT_EQ(b.kept(), none);
}

TEST(unit_quaternions, are_coordinates_and_each_in_one_place) {
  turning_body b;
  const expression q = b.coordinate("q"), v = b.speed("v"), zero = b.number(0.0);
  b.quaternion("halves", b.n, cos(q / 2), sin(q / 2), zero, zero);
  b.quaternion("same", b.n, b.e[0], b.e[1], b.e[2], b.e[3]);
  b.quaternion("conjugate", b.n, b.e[0], -b.e[1], -b.e[2], -b.e[3]);
  b.declare();
  b.kinematics_of(b.body, b.n);
  b.kinematic_equation(b.dot(q) - v);
  EXPECT_EQ(b.kept(), all_four);
}

// A single entry of magnitude one would be 1 or -1 if the other entries vanished.
TEST(unit_quaternions, have_all_parts_at_generic_states) {
  turning_body b;
  for (const double sign : {1.0, -1.0}) {
    kanexpr::symbolic::matrix one(b.graph(), 1, 1);
    one(0, 0) = b.number(1) + b.number(sign) * b.e[0];
    const auto states = kanexpr::mechanics::at_generic_states(one, &b.mechanism());
    ASSERT_EQ(states.size(), 3);
    for (const auto& state : states) {
      EXPECT_GT(state(0, 0), 0);
      EXPECT_LT(state(0, 0), 2);
    }
  }
}

} // namespace
