// builds: sanitize no-exceptions
#include "no_heap.hpp"

#include <gtest/gtest.h>
#include <kanexpr/mechanics/equations.hpp>
#include <kanexpr/runtime/builder.hpp>
#include <kanexpr/runtime/interpreter.hpp>

#include <cmath>
#include <string>

namespace {

using kanexpr::mechanics::components;
using kanexpr::mechanics::equations;
using kanexpr::mechanics::quantity;
using kanexpr::runtime::builder;
using kanexpr::runtime::frame_id;
using kanexpr::runtime::interpreter;
using kanexpr::runtime::point_id;
using kanexpr::runtime::vector;
using kanexpr::symbolic::expression;

// A pendulum on a cart: enough to have something of every kind.
struct pendulum_on_cart : builder {
  expression x = coordinate("x"), theta = coordinate("theta"), v = speed("v"), omega = speed("omega");
  expression m = parameter("m"), length = parameter("l"), push = input("F");
  frame_id n = inertial_frame(), rod;
  point_id o, pivot, bob;

  pendulum_on_cart() : builder("N") {
    const expression zero = number(0);
    rod = rotated("R", n, theta, along(n, 0, 0, 1));
    o = origin("O");
    pivot = offset("C", o, along(n, x, zero, zero));
    bob = offset("P", pivot, along(rod, zero, -length, zero));
    particle("Cart", pivot, number(1));
    particle("Bob", bob, m);
    force(pivot, along(n, push, zero, zero));
    gravity(along(n, 0, -9.81, 0));
    kinematic_equation(dot(x) - v);
    kinematic_equation(dot(theta) - omega);
  }
};

interpreter<double> code_for(builder& b, const kanexpr::symbolic::matrix& wanted) {
  kanexpr::symbolic::sequence<int> outputs;
  for (const expression& e : wanted.entries) outputs.push(e.node());
  return interpreter<double>(kanexpr::lower::tape_of(b.graph(), outputs));
}

double cart_value(const kanexpr::lower::load& l) {
  using kanexpr::symbolic::symbol_kind;
  constexpr double q[]{0.4, 0.3}, u[]{-0.2, 1.5}, p[]{0.5, 0.8};
  switch (l.from) {
  case symbol_kind::coordinate: return q[l.position];
  case symbol_kind::speed: return u[l.position];
  case symbol_kind::parameter: return p[l.position];
  default: return 2; // the push
  }
}

TEST(builder, gives_the_equations_of_what_was_built) {
  pendulum_on_cart b;
  ASSERT_EQ(b.check().view(), "");
  equations derived(b.mechanism());
  double mass[4], force[2];
  code_for(b, derived.get(quantity::mass_matrix)).evaluate(cart_value, mass);
  code_for(b, derived.get(quantity::forcing)).evaluate(cart_value, force);
  const double s = std::sin(0.3), c = std::cos(0.3), ml = 0.5 * 0.8;
  EXPECT_DOUBLE_EQ(mass[0], 1.5);
  EXPECT_DOUBLE_EQ(mass[1], ml * c);
  EXPECT_DOUBLE_EQ(mass[2], mass[1]);
  EXPECT_DOUBLE_EQ(mass[3], ml * 0.8);
  EXPECT_DOUBLE_EQ(force[0], 2 + ml * s * 1.5 * 1.5);
  EXPECT_DOUBLE_EQ(force[1], -ml * 9.81 * s);
}

TEST(interpreter, takes_memory_only_once) {
  pendulum_on_cart b;
  equations derived(b.mechanism());
  interpreter<double> code = code_for(b, derived.get(quantity::udot));
  double udot[2];
  no_heap::guard guard;
  code.evaluate(cart_value, udot);
}

TEST(interpreter, knows_every_operation) {
  builder b("N");
  const expression x = b.parameter("x"), y = b.parameter("y");
  const double at[]{0.7, 0.3};
  const expression all[]{x + y,  x - y,       x * y,       x / y,       -x,      sqrt(x),     sin(x),
                         cos(y), tan(x),      asin(x),     acos(x),     atan(x), atan2(x, y), exp(x),
                         log(x), abs(-x * y), sign(x - y), power(x, y), sin(y)};
  const double expected[]{0.7 + 0.3,
                          0.7 - 0.3,
                          0.7 * 0.3,
                          0.7 / 0.3,
                          -0.7,
                          std::sqrt(0.7),
                          std::sin(0.7),
                          std::cos(0.3),
                          std::tan(0.7),
                          std::asin(0.7),
                          std::acos(0.7),
                          std::atan(0.7),
                          std::atan2(0.7, 0.3),
                          std::exp(0.7),
                          std::log(0.7),
                          0.7 * 0.3,
                          1,
                          std::pow(0.7, 0.3),
                          std::sin(0.3)};
  kanexpr::symbolic::matrix wanted(b.graph(), static_cast<int>(std::size(all)), 1);
  for (int i = 0; i < wanted.rows; ++i) wanted.entries[i] = all[i];
  double found[std::size(all)];
  code_for(b, wanted).evaluate([&](const kanexpr::lower::load& l) { return at[l.position]; }, found);
  for (std::size_t i = 0; i < std::size(all); ++i) EXPECT_EQ(found[i], expected[i]) << "expression " << i;
}

TEST(interpreter, evaluates_in_other_scalar_types) {
  builder b("N");
  const expression x = b.parameter("x");
  kanexpr::symbolic::sequence<int> output{(sin(x) / 3).node()};
  interpreter<long double> code(kanexpr::lower::tape_of(b.graph(), output));
  long double found[1]{};
  code.evaluate([](const kanexpr::lower::load&) { return 0.7L; }, found);
  EXPECT_NEAR(static_cast<double>(found[0] - std::sin(0.7L) / 3), 0, 1e-18);
}

// ---- mistakes: what a person may do wrong, and the sentence that tells it

template <class Mistake>
std::string told(Mistake mistake) {
  pendulum_on_cart b;
  mistake(b);
  return std::string(b.check().view());
}

TEST(builder_mistakes, names_a_frame_or_point_that_does_not_exist) {
  EXPECT_EQ(told([](auto& b) { b.rotated("A", frame_id{7}, b.theta, b.along(b.n, 1, 0, 0)); }),
            "A speaks of frame number 7, which does not exist");
  EXPECT_EQ(told([](auto& b) { b.along(frame_id{-1}, 1, 0, 0); }),
            "a vector speaks of frame number -1, which does not exist");
  EXPECT_EQ(told([](auto& b) { b.offset("A", point_id{9}, b.along(b.n, 1, 0, 0)); }),
            "A speaks of point number 9, which does not exist");
  EXPECT_EQ(told([](auto& b) {
              vector by_hand = b.along(b.n, 1, 0, 0);
              by_hand.parts[0].frame = 5;
              b.force(b.bob, by_hand);
            }),
            "a force speaks of frame number 5, which does not exist");
}

TEST(builder_mistakes, takes_no_expression_of_another_mechanism) {
  pendulum_on_cart other;
  EXPECT_EQ(told([&](auto& b) { b.particle("A", b.bob, other.m); }),
            "A has an expression that belongs to another mechanism or to none");
  EXPECT_EQ(
      told([](auto& b) { b.kinematic_equation(expression()); }),
      "a kinematic differential equation has an expression that belongs to another mechanism or to none");
}

TEST(builder_mistakes, knows_names_that_are_used_twice) {
  EXPECT_EQ(told([](auto& b) { b.parameter("theta"); }), "the name theta is used twice");
  EXPECT_EQ(told([](auto& b) { b.origin("P"); }), "two points are called P");
  EXPECT_EQ(told([](auto& b) { b.rotated("N", b.n, b.theta, b.along(b.n, 1, 0, 0)); }),
            "two frames are called N");
  EXPECT_EQ(told([](auto& b) { b.particle("Bob", b.bob, b.m); }), "two bodies are called Bob");
  EXPECT_EQ(told([](auto& b) { b.origin(""); }), "one of the points has no name");
  EXPECT_EQ(told([](auto& b) { b.speed(std::string(64, 'u')); }),
            "the name " + std::string(64, 'u') + " is longer than a name can be, 63 letters");
}

TEST(builder_mistakes, looks_at_axes_and_sequences) {
  EXPECT_EQ(told([](auto& b) { b.rotated("A", b.n, b.theta, b.along(b.n, 0, 0, 0)); }),
            "frame A is turned about an axis of no length");
  EXPECT_EQ(told([](auto& b) { b.rotated("A", b.n, b.theta, b.along(b.rod, 1, 0, 0)); }),
            "frame A is turned about an axis that is not fixed in N");
  EXPECT_EQ(told([](auto& b) { b.body_fixed("A", b.n, "xxy", b.x, b.x, b.x); }),
            "frame A is turned by the sequence xxy, which is none: three axes, no two neighbours alike");
  EXPECT_EQ(told([](auto& b) { b.dot(b.m); }), "the rate of something that is not a coordinate is asked for");
}

TEST(builder_mistakes, hears_how_something_moves_only_once) {
  EXPECT_EQ(told([](auto& b) {
              b.fixed_in(b.bob, b.rod);
              b.velocity(b.bob, b.n, b.along(b.n, 0, 0, 0));
            }),
            "how point P moves is said twice");
  EXPECT_EQ(told([](auto& b) { b.velocity(b.o, b.n, b.along(b.n, 0, 0, 0)); }),
            "point O is an origin, fixed in the inertial frame, and is said to move");
  EXPECT_EQ(told([](auto& b) { b.angular_velocity(b.n, b.rod, b.along(b.n, 0, 0, 0)); }),
            "the inertial frame N is given an angular velocity");
  EXPECT_EQ(told([](auto& b) {
              for (int i = 0; i < 2; ++i)
                b.angular_velocity(b.rod, b.n, b.along(b.n, b.number(0), b.number(0), b.omega));
            }),
            "frame R is given two angular velocities");
  EXPECT_EQ(told([](auto& b) { b.gravity(b.along(b.n, 0, 0, 1)); }), "gravity is given twice");
}

TEST(builder_mistakes, finds_those_of_the_finished_mechanism) {
  EXPECT_EQ(told([](auto& b) {
              const frame_id a = b.rotated("A", b.rod, b.x, b.along(b.rod, 1, 0, 0));
              b.angular_velocity(b.rod, a, b.along(b.n, 0, 0, 0));
            }),
            "the angular velocity of frame R is given in A, which turns with R");
  EXPECT_EQ(told([](auto& b) { b.coordinate("y"); }),
            "coordinate y has its rate in no kinematic differential equation");
  EXPECT_EQ(told([](auto& b) { b.particle("A", b.bob, b.m * b.theta); }),
            "the mass of A changes with coordinate theta");
}

TEST(builder_mistakes, tells_the_first_one) {
  EXPECT_EQ(told([](auto& b) {
              b.origin("P");
              b.gravity(b.along(frame_id{7}, 0, 0, 1));
            }),
            "two points are called P");
}

} // namespace
