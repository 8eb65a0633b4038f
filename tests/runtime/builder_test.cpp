// builds: clang++ sanitize no-exceptions
#include "no_heap.hpp"

#include <gtest/gtest.h>
#include <kanexpr/mechanics/equations.hpp>
#include <kanexpr/mechanics/motion/observe.hpp>
#include <kanexpr/runtime/builder.hpp>
#include <kanexpr/runtime/interpreter.hpp>
#include <kanexpr/symbolic/printing/print.hpp>

#include <cmath>
#include <numbers>
#include <string>
#include <tuple>

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

// A pendulum on a cart, with an element of every kind.
struct pendulum_on_cart : builder {
  expression x = coordinate("x"), theta = coordinate("theta"), v = speed("v"), omega = speed("omega");
  expression m = parameter("m"), length = parameter("l"), push = input("F");
  frame_id n = inertial_frame(), rod;
  point_id o, pivot, bob;

  pendulum_on_cart() : builder("N") {
    const expression zero = number(0.0);
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
  kanexpr::base::sequence<int> outputs;
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
  equations derived(b.system());
  derived.constrain();
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

// A massless wheel on the rod, and one with an inertia of 0.07 about its axis.
TEST(builder, takes_a_body_without_mass) {
  for (const bool by_parameter : {false, true}) {
    pendulum_on_cart b;
    const expression none = by_parameter ? b.parameter("none") : b.number(0.0), zero = b.number(0.0);
    b.rigid_body("Wheel", b.bob, b.rod, none, b.inertia(b.rod, zero, zero, b.number(0.07)));
    ASSERT_EQ(b.check().view(), "");
    equations derived(b.system());
    derived.constrain();
    double mass[4], force[2], energy[1];
    const auto value = [](const kanexpr::lower::load& l) {
      return l.from == kanexpr::symbolic::symbol_kind::parameter && l.position == 2 ? 0 : cart_value(l);
    };
    code_for(b, derived.get(quantity::mass_matrix)).evaluate(value, mass);
    code_for(b, derived.get(quantity::forcing)).evaluate(value, force);
    code_for(b, derived.get(quantity::kinetic_energy)).evaluate(value, energy);
    const double s = std::sin(0.3), c = std::cos(0.3), ml = 0.5 * 0.8;
    EXPECT_NEAR(mass[0], 1.5, 1e-15);
    EXPECT_NEAR(mass[1], ml * c, 1e-15);
    EXPECT_NEAR(mass[3], ml * 0.8 + 0.07, 1e-15);
    EXPECT_NEAR(force[0], 2 + ml * s * 1.5 * 1.5, 1e-15);
    EXPECT_NEAR(force[1], -ml * 9.81 * s, 1e-15);
    EXPECT_NEAR(energy[0], (1.5 * 0.04 + 2 * ml * c * -0.2 * 1.5 + (ml * 0.8 + 0.07) * 1.5 * 1.5) / 2, 1e-15);
  }
}

using kanexpr::symbolic::print;

TEST(builder, a_known_motion_takes_up_points_that_come_later) {
  pendulum_on_cart b;
  kanexpr::mechanics::known_motion known(b.mechanism());
  EXPECT_FALSE(kanexpr::mechanics::velocity_of_point(known.moving(), place(b.bob)).is_zero());
  const kanexpr::runtime::point_id half = b.offset("half", b.o, b.along(b.n, b.x, 0, 0));
  const auto v = kanexpr::mechanics::velocity_of_point(known.moving(), place(half));
  EXPECT_EQ(print(kanexpr::mechanics::express(b.mechanism(), v, 0).x), "v");
}

TEST(builder, keeps_constraints_and_what_depends_on_them) {
  pendulum_on_cart b;
  kanexpr::mechanics::known_motion known(b.mechanism());
  b.velocity_constraint(kanexpr::mechanics::velocity_of_point(known.moving(), place(b.bob)),
                        b.along(b.n, 1, 0, 0));
  b.velocity_constraint(b.v - b.length * b.omega);
  b.configuration_constraint(b.x - b.length * sin(b.theta));
  b.acceleration_constraint(b.dot(b.v) - b.dot(b.omega));
  b.dependent(b.omega);
  b.dependent(b.x);
  const kanexpr::mechanics::given_constraints& c = b.system().constraints;
  ASSERT_EQ(b.mistake().view(), "");
  ASSERT_EQ(c.on_velocities.size(), 2);
  EXPECT_EQ(print(c.on_velocities[0].value), "l*omega*cos(theta) + v");
  EXPECT_EQ(c.on_velocities[0].vanishing.parts.size(), 1);
  EXPECT_EQ(c.on_velocities[0].direction.parts.size(), 1);
  EXPECT_EQ(print(c.on_velocities[1].value), "v - l*omega");
  EXPECT_TRUE(c.on_velocities[1].vanishing.parts.empty());
  ASSERT_EQ(c.on_configuration.size(), 1);
  EXPECT_EQ(print(c.on_configuration[0]), "x - l*sin(theta)");
  ASSERT_EQ(c.on_accelerations.size(), 1);
  EXPECT_EQ(print(c.on_accelerations[0]), "v' - omega'");
  ASSERT_EQ(c.dependent_speeds.size(), 1);
  EXPECT_EQ(c.dependent_speeds[0], 1);
  ASSERT_EQ(c.dependent_coordinates.size(), 1);
  EXPECT_EQ(c.dependent_coordinates[0], 0);
}

TEST(builder, derives_what_is_constrained) {
  pendulum_on_cart b;
  b.velocity_constraint(b.v); // the cart is at rest
  ASSERT_EQ(b.check().view(), "");
  equations derived(b.system());
  derived.constrain();
  ASSERT_EQ(derived.mistake().view(), "");
  double udot[2];
  code_for(b, derived.get(quantity::udot)).evaluate(cart_value, udot);
  EXPECT_NEAR(udot[0], 0, 1e-14);
  EXPECT_NEAR(udot[1], -9.81 / 0.8 * std::sin(0.3), 1e-14);
}

TEST(builder, places_a_prescribed_quantity_with_its_derivatives) {
  builder b("N");
  const expression push = b.input("F"), turn = b.prescribed("turn");
  const kanexpr::mechanics::mechanism& m = b.mechanism();
  ASSERT_EQ(m.inputs.size(), 4);
  EXPECT_EQ(m.inputs[0], push);
  EXPECT_EQ(m.inputs[1], turn);
  EXPECT_EQ(m.inputs[2], b.dot(turn));
  EXPECT_EQ(m.inputs[3], b.dot(b.dot(turn)));
  EXPECT_EQ(print(m.inputs[3]), "turn''");
  EXPECT_EQ(b.mistake().view(), "");
}

TEST(builder, writes_the_kinematics_of_a_frame) {
  builder b("N");
  const frame_id n = b.inertial_frame();
  const expression yaw = b.coordinate("yaw"), lean = b.coordinate("lean"), spin = b.coordinate("spin");
  const expression u1 = b.speed("u1"), u2 = b.speed("u2"), u3 = b.speed("u3"), ua = b.auxiliary_speed("ua");
  const frame_id y = b.rotated("Y", n, yaw, b.along(n, 0, 0, 1));
  const frame_id l = b.rotated("L", y, lean, b.along(y, 1, 0, 0));
  const frame_id r = b.rotated("R", l, spin, b.along(l, 0, 1, 0));
  b.angular_velocity(r, n, b.along(l, u1, u2 + ua, u3));
  b.kinematics_of(r, n);
  ASSERT_EQ(b.mistake().view(), "");
  ASSERT_EQ(b.mechanism().kinematics.size(), 3);
  EXPECT_EQ(print(b.mechanism().kinematics[0]), "u1 - lean'");
  EXPECT_EQ(print(b.mechanism().kinematics[1]), "u2 - spin' - yaw'*sin(lean)");
  EXPECT_EQ(print(b.mechanism().kinematics[2]), "u3 - yaw'*cos(lean)");
}

TEST(interpreter, takes_memory_only_once) {
  pendulum_on_cart b;
  equations derived(b.system());
  derived.constrain();
  interpreter<double> code = code_for(b, derived.get(quantity::udot));
  double udot[2];
  no_heap::guard guard;
  code.evaluate(cart_value, udot);
}

TEST(interpreter, knows_every_operation) {
  builder b("N");
  const expression x = b.parameter("x"), y = b.parameter("y");
  const double at[]{0.7, 0.3};
  const expression all[]{x + y,
                         x - y,
                         x * y,
                         x / y,
                         -x,
                         sqrt(x),
                         sin(x),
                         cos(y),
                         tan(x),
                         asin(x),
                         acos(x),
                         atan(x),
                         atan2(x, y),
                         exp(x),
                         log(x),
                         abs(-x * y),
                         sign(x - y),
                         power(x, y),
                         sin(y),
                         if_positive(x - y, sqrt(x - y), sqrt(y - x)),
                         clamp(3 * x, y, x),
                         hypot(x, y),
                         cbrt(-x),
                         erf(x),
                         wrap_to_pi(10 * x)};
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
                          std::sin(0.3),
                          std::sqrt(0.7 - 0.3),
                          0.7,
                          std::sqrt(0.7 * 0.7 + 0.3 * 0.3),
                          std::cbrt(-0.7),
                          std::erf(0.7),
                          std::remainder(7.0, 2 * std::numbers::pi)};
  kanexpr::symbolic::matrix wanted(b.graph(), static_cast<int>(std::size(all)), 1);
  for (int i = 0; i < wanted.rows; ++i) wanted.entries[i] = all[i];
  double found[std::size(all)];
  code_for(b, wanted).evaluate([&](const kanexpr::lower::load& l) { return at[l.position]; }, found);
  for (std::size_t i = 0; i < std::size(all); ++i)
    EXPECT_DOUBLE_EQ(found[i], expected[i]) << "expression " << i;
}

TEST(interpreter, evaluates_in_other_scalar_types) {
  builder b("N");
  const expression x = b.parameter("x");
  kanexpr::base::sequence<int> output{(sin(x) / 3).node()};
  interpreter<long double> code(kanexpr::lower::tape_of(b.graph(), output));
  long double found[1]{};
  code.evaluate([](const kanexpr::lower::load&) { return 0.7L; }, found);
  EXPECT_NEAR(static_cast<double>(found[0] - std::sin(0.7L) / 3), 0, 1e-18);
}

// ---- mistakes and the sentences that report them

template <class Mistake>
std::string told(Mistake mistake) {
  pendulum_on_cart b;
  mistake(b);
  return std::string(b.check().view());
}

TEST(builder, takes_numbers_beside_expressions) {
  pendulum_on_cart b;
  const vector mixed = b.along(b.rod, 0, -b.length, 2.5),
               plain = b.along(b.rod, b.number(0.0), -b.length, b.number(2.5));
  for (int i = 0; i < 3; ++i) EXPECT_EQ(mixed.parts[0].value[i], plain.parts[0].value[i]);
  b.rigid_body("Rod", b.bob, b.rod, b.m, b.inertia(b.rod, 0, 0, b.m * b.length * b.length));
  EXPECT_EQ(print(1.5 - (0.5 + b.x / 2.5) / 0.25 + 2.5 * b.m - 0.75),
            print(b.number(1.5) - (b.number(0.5) + b.x / b.number(2.5)) / b.number(0.25) +
                  b.number(2.5) * b.m - b.number(0.75)));
  EXPECT_EQ(print(0.5 / b.m + b.x * (b.m + 0.25)), print(b.number(0.5) / b.m + b.x * (b.m + b.number(0.25))));
  // not truncated to an int
  EXPECT_EQ(print(b.m * 9.81 + b.x * 0.5F), print(9.81 * b.m + 0.5 * b.x));
  EXPECT_EQ(print(b.m * 5'000'000'000 + 3U * b.x), print(5e9 * b.m + 3.0 * b.x));
  EXPECT_EQ(b.check().view(), "");
  EXPECT_EQ(print(b.dot(mixed, b.along(b.n, 1, 0, 0))), "l*sin(theta)");
}

TEST(builder, closes_a_loop_along_directions) {
  const auto equations_with = [](auto close) {
    builder b("N");
    const auto q1 = b.coordinate("q1"), q2 = b.coordinate("q2"), s = b.coordinate("s");
    const auto n = b.inertial_frame();
    const frame_id crank = b.rotated("A", n, q1, b.along(n, 0, 0, 1)),
                   rod = b.rotated("B", n, q2, b.along(n, 0, 0, 1));
    const point_id o = b.origin("O"), slider = b.offset("S", o, b.along(n, s, 0, 0));
    const point_id end = b.offset("Q", b.offset("P", o, b.along(crank, 0.1, 0, 0)), b.along(rod, 0.3, 0, 0));
    close(b, end, slider, q1, q2, s);
    std::string all;
    for (const expression& e : b.system().constraints.on_configuration) all += print(e) + "; ";
    EXPECT_EQ(b.mistake().view(), "");
    return all;
  };
  EXPECT_EQ(equations_with([](builder& b, point_id end, point_id slider, auto...) {
              const auto n = b.inertial_frame();
              b.configuration_constraint(
                  b.zero_along(b.position_of(end, slider), b.along(n, 1, 0, 0), b.along(n, 0, 1, 0)));
            }),
            equations_with([](builder& b, point_id, point_id, auto q1, auto q2, auto s) {
              b.configuration_constraint(b.number(0.1) * cos(q1) + b.number(0.3) * cos(q2) - s);
              b.configuration_constraint(b.number(0.1) * sin(q1) + b.number(0.3) * sin(q2));
            }));
}

TEST(builder, keeps_a_velocity_from_directions) {
  const auto constraint_with = [](auto bind) {
    pendulum_on_cart b;
    kanexpr::mechanics::known_motion known(b.mechanism());
    bind(b, kanexpr::mechanics::velocity_of_point(known.moving(), place(b.bob)));
    EXPECT_EQ(b.mistake().view(), "");
    return print(b.system().constraints.on_velocities[0].value);
  };
  EXPECT_EQ(
      constraint_with(
          [](auto& b, const vector& v) { b.velocity_constraint(b.zero_along(v, b.along(b.rod, 1, 0, 0))); }),
      constraint_with([](auto& b, const vector& v) { b.velocity_constraint(v, b.along(b.rod, 1, 0, 0)); }));
}

TEST(builder_mistakes, names_a_frame_or_point_that_does_not_exist) {
  EXPECT_EQ(told([](auto& b) { b.rotated("A", frame_id{7}, b.theta, b.along(b.n, 1, 0, 0)); }),
            "A refers to frame number 7, which does not exist");
  EXPECT_EQ(told([](auto& b) { b.along(frame_id{-1}, 1, 0, 0); }),
            "a vector refers to frame number -1, which does not exist");
  EXPECT_EQ(told([](auto& b) { b.offset("A", point_id{9}, b.along(b.n, 1, 0, 0)); }),
            "A refers to point number 9, which does not exist");
  EXPECT_EQ(told([](auto& b) {
              vector by_hand = b.along(b.n, 1, 0, 0);
              by_hand.parts[0].frame = 5;
              b.force(b.bob, by_hand);
            }),
            "a force refers to frame number 5, which does not exist");
}

TEST(builder_mistakes, takes_no_expression_of_another_mechanism) {
  pendulum_on_cart other;
  EXPECT_EQ(told([&](auto& b) { b.particle("A", b.bob, other.m); }),
            "A contains an expression that belongs to a different mechanism or to none");
  EXPECT_EQ(told([](auto& b) { b.kinematic_equation(expression()); }),
            "a kinematic differential equation contains an expression that belongs to a different mechanism "
            "or to none");
}

TEST(builder_mistakes, knows_names_that_are_used_twice) {
  EXPECT_EQ(told([](auto& b) { b.parameter("theta"); }), "the name theta is used twice");
  EXPECT_EQ(told([](auto& b) { b.origin("P"); }), "two points are called P");
  EXPECT_EQ(told([](auto& b) { b.rotated("N", b.n, b.theta, b.along(b.n, 1, 0, 0)); }),
            "two frames are called N");
  EXPECT_EQ(told([](auto& b) { b.particle("Bob", b.bob, b.m); }), "two bodies are called Bob");
  EXPECT_EQ(told([](auto& b) { b.origin(""); }), "one of the points has no name");
}

TEST(builder_mistakes, knows_what_a_name_is) {
  EXPECT_EQ(told([](auto& b) { b.parameter(""); }), "one of the symbols has no name");
  EXPECT_EQ(told([](auto& b) { b.used_elsewhere(b.parameter(std::string(60, 'k'))); }), "");
  EXPECT_EQ(told([](auto& b) { b.speed(std::string(61, 'u')); }),
            "the name " + std::string(61, 'u') + " is longer than 60 characters");
  EXPECT_EQ(told([](auto& b) { b.input("th'"); }), "the name th' contains a prime, which denotes a rate");
  EXPECT_EQ(told([](auto& b) { b.rotated("R'", b.n, b.theta, b.along(b.n, 0, 0, 1)); }),
            "the name R' contains a prime, which denotes a rate");
  EXPECT_EQ(told([](auto& b) { b.parameter("2m"); }), "the name 2m does not begin with a letter");
  EXPECT_EQ(told([](auto& b) { b.used_elsewhere(b.parameter("θ")); }), "");
  for (const char* called : {"a\"b", "a\nb", "a\x7f"})
    EXPECT_EQ(told([&](auto& b) { b.parameter(called); }),
              "the name of one of the symbols contains a quote or a control character");
  for (const char* called : {"a\xff", "m\xc3", "\xc0\xafz", "k\xed\xa0\x80", "\xf5\x80\x80\x80"})
    EXPECT_EQ(told([&](auto& b) { b.parameter(called); }),
              "the name of one of the symbols is not valid UTF-8");
  EXPECT_EQ(told([](auto& b) { b.origin("P\x80"); }), "the name of one of the points is not valid UTF-8");
  EXPECT_EQ(told([](auto& b) { b.used_elsewhere(b.parameter("t")); }), "");
  EXPECT_EQ(told([](auto& b) { b.parameter("t"), b.time(); }), "the name t is used twice");
  EXPECT_EQ(told([](auto& b) { b.time(), b.time(), b.parameter("t"); }), "the name t is used twice");
}

// A name that is too long for a sentence is shortened in the middle.
TEST(builder_mistakes, keep_the_ends_of_names) {
  const auto called = [](char last) { return "Link" + std::string(300, 'x') + last; };
  for (const char last : {'a', 'b'}) {
    const std::string found(kanexpr::base::sentence({"two frames are called ", called(last)}).view());
    EXPECT_TRUE(found.starts_with("two frames are called Linkxx")) << found;
    EXPECT_TRUE(found.ends_with(std::string("xx") + last)) << found;
    EXPECT_EQ(found.size(), 255u);
    const kanexpr::base::name name(called(last));
    EXPECT_TRUE(name.view().starts_with("Linkxx") && name.view().ends_with(std::string("xx") + last));
  }
}

TEST(builder_mistakes, looks_at_axes_and_sequences) {
  EXPECT_EQ(told([](auto& b) { b.rotated("A", b.n, b.theta, b.along(b.n, 0.0, 0, 0)); }),
            "frame A is rotated about an axis of zero length");
  EXPECT_EQ(told([](auto& b) { b.rotated("A", b.n, b.theta, b.along(b.rod, 1, 0, 0)); }),
            "frame A is rotated about an axis that is not fixed in N");
  EXPECT_EQ(told([](auto& b) { b.body_fixed("A", b.n, "xxy", b.x, b.x, b.x); }),
            "frame A is rotated by the sequence xxy, which is invalid; use three axes, no two consecutive "
            "ones equal");
  EXPECT_EQ(told([](auto& b) { b.dot(b.m); }),
            "the argument of dot is not a coordinate, speed or prescribed quantity");
}

TEST(builder_mistakes, hears_how_something_moves_only_once) {
  EXPECT_EQ(told([](auto& b) {
              b.fixed_in(b.bob, b.rod);
              b.velocity(b.bob, b.n, b.along(b.n, 0.0, 0, 0));
            }),
            "point P has two declared motions");
  EXPECT_EQ(told([](auto& b) { b.velocity(b.o, b.n, b.along(b.n, 0.0, 0, 0)); }),
            "point O is an origin, fixed in the inertial frame, but has a declared motion");
  EXPECT_EQ(told([](auto& b) { b.angular_velocity(b.n, b.rod, b.along(b.n, 0.0, 0, 0)); }),
            "the inertial frame N has a declared angular velocity");
  EXPECT_EQ(told([](auto& b) {
              for (int i = 0; i < 2; ++i)
                b.angular_velocity(b.rod, b.n, b.along(b.n, b.number(0.0), b.number(0.0), b.omega));
            }),
            "frame R has two declared angular velocities");
  EXPECT_EQ(told([](auto& b) { b.gravity(b.along(b.n, 0, 0, 1)); }), "gravity is specified twice");
}

TEST(builder_mistakes, hears_of_a_force_only_once) {
  EXPECT_EQ(told([](auto& b) { b.force(b.pivot, b.along(b.n, b.push, b.number(0.0), b.number(0.0))); }),
            "the force at C is listed twice");
  EXPECT_EQ(told([](auto& b) { b.force(b.pivot, b.along(b.n, -b.push, b.number(0.0), b.number(0.0))); }), "");
  EXPECT_EQ(told([](auto& b) { b.force(b.bob, b.along(b.n, b.number(0.0), -9.81 * b.m, b.number(0.0))); }),
            "the force at P is the weight of Bob, which gravity already applies");
}

TEST(builder_mistakes, finds_weights_beside_gravity) {
  const auto weigh = [](auto& b, int frame) { // in inertial axes or in those of the rod
    const expression w = 9.81 * b.m;
    return frame == 0 ? b.along(b.n, b.push, -w, b.number(0.0))
                      : b.along(b.rod, b.push - w * sin(b.theta), -w * cos(b.theta), b.number(0.0));
  };
  for (int frame : {0, 1}) {
    EXPECT_EQ(told([&](auto& b) { b.force(b.bob, weigh(b, frame)); }),
              "the force at P contains the weight of Bob, which gravity already applies");
    EXPECT_EQ(told([&](auto& b) { b.force_between(b.bob, b.o, weigh(b, frame)); }),
              "the force between P and O contains the weight of Bob, which gravity already applies");
    EXPECT_EQ(told([&](auto& b) { b.force(b.pivot, weigh(b, frame)); }), "") << "the weight of another";
  }
  EXPECT_EQ(told([](auto& b) { b.potential_energy(9.81 * b.m * b.length * (2 - cos(b.theta))); }),
            "potential energy 1 includes the energy of the weight of Bob, which gravity already applies");
  EXPECT_EQ(told([](auto& b) { b.potential_energy(9.81 * b.m * b.length * cos(b.theta)); }), "") << "a lift";
  EXPECT_EQ(told([](auto& b) { b.potential_energy(9.81 * b.m * b.length * sin(b.theta)); }), "");
}

// A stiff spring beside the weight neither hides it nor makes something else look like it.
TEST(builder_mistakes, compares_weights_to_their_own_digits) {
  const auto told_of = [](double share, double stiffness) {
    builder b("N");
    const auto z = b.coordinate("z"), u = b.speed("u");
    b.kinematic_equation(b.dot(z) - u);
    const auto n = b.inertial_frame();
    b.particle("Bob", b.offset("P", b.origin("O"), b.along(n, 0, 0, z)), b.number(2));
    b.gravity(b.along(n, 0, 0, -9.81));
    b.potential_energy(share * 2 * 9.81 * z + stiffness * z * z);
    return std::string((b.check)().view());
  };
  for (const double stiffness : {0.5, 5e10, 4e12}) {
    EXPECT_EQ(told_of(0.99, stiffness), "") << stiffness;
    EXPECT_EQ(told_of(1, stiffness),
              "potential energy 1 includes the energy of the weight of Bob, which gravity already applies")
        << stiffness;
  }
}

TEST(builder_mistakes, hears_of_any_load_only_once) {
  EXPECT_EQ(told([](auto& b) {
              b.spring(b.bob, b.o, b.m);
              b.spring(b.o, b.bob, b.m);
            }),
            "the spring between P and O is listed twice");
  EXPECT_EQ(told([](auto& b) {
              b.spring(b.bob, b.o, b.m);
              b.spring(b.o, b.bob, b.m, b.length);
            }),
            "");
  EXPECT_EQ(told([](auto& b) {
              b.damper(b.bob, b.o, b.m);
              b.damper(b.bob, b.o, b.m);
            }),
            "the damper between P and O is listed twice");
  EXPECT_EQ(told([](auto& b) {
              b.torsional_damper(b.rod, b.n, b.m);
              b.torsional_damper(b.n, b.rod, b.m);
            }),
            "the torsional damper between R and N is listed twice");
  EXPECT_EQ(told([](auto& b) {
              b.torsional_spring(b.theta, b.m);
              b.potential_energy(b.m * b.theta * b.theta / 2);
            }),
            "potential energy 2 repeats potential energy 1");
  EXPECT_EQ(told([](auto& b) {
              b.torsional_spring(b.theta, b.m);
              b.torsional_spring(b.theta, b.m, b.number(1));
            }),
            "");
  EXPECT_EQ(told([](auto& b) { b.force_between(b.o, b.pivot, b.along(b.n, -b.push, 0.0, 0.0)); }),
            "the force between O and C repeats the force at C");
  EXPECT_EQ(told([](auto& b) { b.force_between(b.pivot, b.bob, b.along(b.n, b.push, 0.0, 0.0)); }),
            "the force between C and P repeats the force at C");
  EXPECT_EQ(told([](auto& b) { b.force_between(b.bob, b.o, b.along(b.n, b.push, 0.0, 0.0)); }), "");
  EXPECT_EQ(told([](auto& b) {
              b.torque_between(b.rod, b.n, b.along(b.rod, 0.0, 0.0, b.push));
              b.torque(b.rod, b.along(b.n, 0.0, 0.0, b.push));
            }),
            "the torque on R repeats the torque between R and N");
}

TEST(builder_mistakes, compares_velocities_with_positions) {
  const std::string expected = "the velocity of point Q is not the rate of its position; if this is "
                               "intended, write velocity_apart_from_position";
  const auto slides = [](auto& b, bool apart) {
    const auto place = b.offset("Q", b.o, b.along(b.rod, b.x, 0, 0));
    b.particle("Bead", place, b.m);
    if (apart)
      b.velocity_apart_from_position(place, b.n, b.along(b.rod, b.dot(b.x), 0, 0));
    else
      b.velocity(place, b.n, b.along(b.rod, b.dot(b.x), 0, 0));
  };
  EXPECT_EQ(told([&](auto& b) { slides(b, false); }), expected);
  EXPECT_EQ(told([&](auto& b) { slides(b, true); }), "");
  EXPECT_EQ(told([](auto& b) { // in the axes of the rod
              const auto place = b.offset("Q", b.o, b.along(b.rod, b.x, 0, 0));
              b.velocity(place, b.rod, b.along(b.rod, b.dot(b.x), 0, 0));
            }),
            "");
}

// An equality holds only at some states, or is hidden by a large term.
TEST(builder_mistakes, compares_velocities_at_many_states_and_with_each_speed) {
  const std::string
      velocity = "the velocity of point Q is not the rate of its position; if this is intended, "
                 "write velocity_apart_from_position",
      mass = "point Q is fixed in R, but its offset from S changes in that frame; if this is intended, "
             "write velocity_apart_from_position";
  const auto stops = [](auto& b, bool wrong) { // against a wall at 0
    const expression zero = b.number(0.0), x = max(b.x, zero);
    const auto place = b.offset("Q", b.o, b.along(b.n, x, 0, 0));
    b.particle("Bead", place, b.m);
    b.velocity(place, b.n, b.along(b.n, wrong ? zero : if_positive(b.x, b.dot(b.x), zero), 0, 0));
  };
  EXPECT_EQ(told([&](auto& b) { stops(b, true); }), velocity);
  EXPECT_EQ(told([&](auto& b) { stops(b, false); }), "");
  const auto orbits = [](auto& b, bool wrong) {
    const double far = 1.5e11; // m, from the sun
    const auto place = b.offset("Q", b.o, b.along(b.rod, far, 0, 0) + b.along(b.n, 0, b.x, 0));
    b.particle("Bead", place, b.m);
    b.velocity(place, b.n, b.along(b.rod, 0, far * b.omega, 0) + b.along(b.n, 0, wrong ? 2 * b.v : b.v, 0));
  };
  EXPECT_EQ(told([&](auto& b) { orbits(b, true); }), velocity);
  EXPECT_EQ(told([&](auto& b) { orbits(b, false); }), "");
  const auto carries = [](auto& b, bool wrong) { // a mass placed along N that turns with the rod
    const auto far = b.offset("S", b.o, b.along(b.rod, 1.5e11, 0, 0));
    const auto place = b.offset("Q", far, b.along(wrong ? b.n : b.rod, 1, 0, 0));
    b.fixed_in(place, b.rod);
    b.particle("Bead", place, b.m);
  };
  EXPECT_EQ(told([&](auto& b) { carries(b, true); }), mass);
  EXPECT_EQ(told([&](auto& b) { carries(b, false); }), "");
}

TEST(builder_mistakes, looks_at_constraints) {
  const std::string foreign = " contains an expression that belongs to a different mechanism or to none";
  EXPECT_EQ(told([](auto& b) { b.configuration_constraint(expression()); }),
            "a configuration constraint" + foreign);
  EXPECT_EQ(told([](auto& b) { b.velocity_constraint(expression()); }), "a velocity constraint" + foreign);
  EXPECT_EQ(told([](auto& b) { b.acceleration_constraint(expression()); }),
            "an acceleration constraint" + foreign);
  EXPECT_EQ(
      told([](auto& b) { b.velocity_constraint(b.along(b.n, 1, 0, 0), b.along(frame_id{4}, 1, 0, 0)); }),
      "a vector refers to frame number 4, which does not exist");
  EXPECT_EQ(told([](auto& b) { b.velocity_constraint(b.along(b.n, 1, 0, 0), b.along(b.n, 0.0, 0, 0)); }),
            "a velocity constraint has a direction of zero length");
  EXPECT_EQ(told([](auto& b) { b.dependent(expression()); }), "the argument of dependent" + foreign);
  EXPECT_EQ(told([](auto& b) { b.dependent(b.m); }),
            "the argument of dependent is neither a coordinate nor a speed");
  EXPECT_EQ(told([](auto& b) {
              b.dependent(b.v);
              b.dependent(b.v);
            }),
            "v is declared dependent twice");
}

TEST(builder_mistakes, looks_at_auxiliary_speeds_and_prescribed_quantities) {
  EXPECT_EQ(told([](auto& b) { b.auxiliary_speed("v"); }), "the name v is used twice");
  EXPECT_EQ(told([](auto& b) { b.dot(b.auxiliary_speed("ua")); }),
            "the argument of dot is not a coordinate, speed or prescribed quantity");
  EXPECT_EQ(told([](auto& b) { b.prescribed("F"); }), "the name F is used twice");
  EXPECT_EQ(told([](auto& b) { b.dot(b.dot(b.dot(b.prescribed("turn")))); }),
            "the argument of dot is not a coordinate, speed or prescribed quantity");
}

TEST(builder_mistakes, looks_at_frames_whose_kinematics_are_asked_for) {
  EXPECT_EQ(told([](auto& b) { b.kinematics_of(frame_id{7}, b.n); }),
            "kinematics_of refers to frame number 7, which does not exist");
  EXPECT_EQ(told([](auto& b) { b.kinematics_of(b.rod, b.n); }),
            "kinematics_of<R, N> is not available: frame R has no declared angular velocity");
  EXPECT_EQ(told([](auto& b) { b.kinematics_of(b.n, b.rod); }),
            "kinematics_of<N, R> is not available: frame N is not oriented relative to R");
}

TEST(builder_mistakes, finds_those_of_the_finished_mechanism) {
  EXPECT_EQ(told([](auto& b) {
              const frame_id a = b.rotated("A", b.rod, b.x, b.along(b.rod, 1, 0, 0));
              b.angular_velocity(b.rod, a, b.along(b.n, 0.0, 0, 0));
            }),
            "the angular velocity of frame R is given relative to A, which turns with R");
  EXPECT_EQ(told([](auto& b) { b.coordinate("y"); }),
            "the rate of coordinate y appears in no kinematic differential equation");
  EXPECT_EQ(told([](auto& b) { b.particle("A", b.bob, b.m * b.omega); }),
            "the mass of A depends on the speed omega");
}

// In C++, 1/2 is the integer 0.
TEST(builder_mistakes, takes_no_whole_zero) {
  const std::string which = ", which is also the value of 1/2 in C++; write ",
                    meant = ", or 0.0 if you mean zero";
  EXPECT_EQ(told([](auto& b) { b.particle("A", b.bob, b.number(1 / 2)); }),
            "the argument of number is 0" + which + "0.5" + meant);
  EXPECT_EQ(told([](auto& b) { b.particle("A", b.bob, b.m + b.number(0.0)); }), "");
  EXPECT_EQ(told([](auto& b) { b.potential_energy(1 / 2 * b.m * b.x * b.x); }),
            "a potential energy contains an operation with the integer 0" + which + "x/2 or 0.5*x" + meant);
  EXPECT_EQ(told([](auto& b) { b.force(b.bob, b.along(b.n, 0, b.m * 1 / 3 * (b.x + 1 / 2), 0)); }),
            "a vector contains an operation with the integer 0" + which + "x/2 or 0.5*x" + meant);
  EXPECT_EQ(told([](auto& b) { b.force(b.bob, b.along(b.n, 0, 0, 1 / 2)); }),
            "every component of a vector is 0" + which + "0.5" + meant);
  EXPECT_EQ(
      told([](auto& b) { b.rigid_body("Rod", b.bob, b.rod, b.m, b.inertia(b.rod, 1 / 12, 0, 1 / 12)); }),
      "every entry of an inertia is 0" + which + "0.5" + meant);
  EXPECT_EQ(told([](auto& b) { b.force(b.bob, b.along(b.n, 0.0, 0, 0)); }), "");
}

TEST(builder_mistakes, finds_what_is_made_and_used_by_nothing) {
  EXPECT_EQ(told([](auto& b) { b.parameter("d"); }),
            "parameter d is declared but not used in the system; if this is intended, call used_elsewhere");
  EXPECT_EQ(told([](auto& b) { b.input("T"); }),
            "input T is declared but not used in the system; if this is intended, call used_elsewhere");
  EXPECT_EQ(told([](auto& b) {
              const expression r = b.prescribed("r");
              b.force(b.bob, b.along(b.n, b.dot(r), 0, 0)); // its rates are inputs, too
            }),
            "");
  EXPECT_EQ(told([](auto& b) { b.auxiliary_speed("lift"); }),
            "auxiliary speed lift is declared but not used in the system");
  EXPECT_EQ(told([](auto& b) { b.velocity_constraint(b.v - b.parameter("w")); }), "");
  EXPECT_EQ(told([](auto& b) { b.used_elsewhere(b.parameter("d")), b.used_elsewhere(b.input("T")); }), "");
  EXPECT_EQ(told([](auto& b) { b.used_elsewhere(b.x); }),
            "the argument of used_elsewhere is neither a parameter nor an input");
}

template <class Value>
concept multiplies_expressions = requires(Value value, expression e) { value* e; };

TEST(builder_mistakes, takes_no_letter_and_no_limits_out_of_order) {
  static_assert(multiplies_expressions<int> && !multiplies_expressions<char>);
  static_assert(!std::is_constructible_v<kanexpr::runtime::number_or_expression, char>);
  EXPECT_EQ(
      told([](auto& b) { b.force(b.bob, b.along(b.n, clamp(b.push, b.number(1), b.number(-1)), 0.0, 0.0)); }),
      "a vector contains clamp with limits out of order; write clamp(x, least, most)");
  EXPECT_EQ(
      told([](auto& b) { b.force(b.bob, b.along(b.n, clamp(b.push, b.number(-1), b.number(1)), 0.0, 0.0)); }),
      "");
}

TEST(builder_mistakes, takes_no_number_that_is_none) {
  EXPECT_EQ(told([](auto& b) { b.gravity(b.along(b.n, std::nan(""), 0, 1)); }),
            "the argument of number is not finite");
  EXPECT_EQ(told([](auto& b) { b.potential_energy(b.x * (0.0 / (b.m - b.m))); }),
            "a potential energy contains a number that is not finite");
  EXPECT_EQ(told([](auto& b) { b.particle("A", b.bob, b.m + acos(b.number(2)) * b.x); }),
            "A contains a number that is not finite");
  EXPECT_EQ(told([](auto& b) { b.particle("A", b.bob, b.m / (b.m - b.m)); }),
            "A contains a number that is not finite");
  EXPECT_EQ(told([](auto& b) { b.potential_energy(b.x * power(b.number(0.0), b.number(-1))); }),
            "a potential energy contains a number that is not finite");
  EXPECT_EQ(told([](auto& b) { b.potential_energy(b.x * (b.number(1e200) * b.number(1e200))); }),
            "a potential energy contains a number that is not finite");
}

kanexpr::mechanics::matrix3 rows(pendulum_on_cart& b, std::initializer_list<double> numbers) {
  kanexpr::mechanics::matrix3 m;
  const double* next = numbers.begin();
  for (int i = 0; i < 9; ++i) m(i / 3, i % 3) = b.number(*next++);
  return m;
}

TEST(builder_mistakes, looks_at_numbers_of_orientations) {
  const auto turned = [](std::initializer_list<double> numbers) {
    return told([&](auto& b) { b.direction_cosines("A", b.n, rows(b, numbers)); });
  };
  EXPECT_EQ(turned({0.6, -0.8, 0, 0.8, 0.6, 0, 0, 0, 1}), "");
  EXPECT_EQ(turned({0.8660254, -0.5, 0, 0.5, 0.8660254, 0, 0, 0, 1}), ""); // as written
  const std::string skew = "the direction cosines of frame A are not orthonormal; write irrational entries "
                           "as sqrt or cos of numbers";
  EXPECT_EQ(turned({0.6, 0.8, 0, 0.8, 0.6, 0, 0, 0, 1}), skew);
  EXPECT_EQ(turned({0.6, -0.8, 0, 0.8, 0.6, 0, 0, 0, 2}), skew);
  EXPECT_EQ(turned({0.6, -0.8, 0, 0.8, 0.6, 0, 0, 0, 1e200}), skew);
  EXPECT_EQ(told([](auto& b) { b.rotated("A", b.n, b.theta, b.along(b.n, 1e200, 1, 0)); }),
            "the axis of frame A is too long or too short to be normalized");
  EXPECT_EQ(turned({0.6, 0.8, 0, 0.8, -0.6, 0, 0, 0, 1}),
            "the direction cosines of frame A are not right-handed: they describe a reflection");
  EXPECT_EQ(told([](auto& b) {
              kanexpr::mechanics::matrix3 m = rows(b, {0, 0, 0, 0, 0, 0, 0, 0, 2});
              m(0, 0) = m(1, 1) = cos(b.theta), m(1, 0) = sin(b.theta), m(0, 1) = -sin(b.theta);
              b.direction_cosines("A", b.n, m);
            }),
            skew);
  const auto quaternion = [](double e0, double e3) {
    return told(
        [&](auto& b) { b.quaternion("A", b.n, b.number(e0), b.number(0.0), b.number(0.0), b.number(e3)); });
  };
  EXPECT_EQ(quaternion(0.6, 0.8), "");
  const std::string no_unit = "the quaternion of frame A does not have unit length";
  EXPECT_EQ(quaternion(1, 1), no_unit);
  EXPECT_EQ(quaternion(0, 0), no_unit);
  EXPECT_EQ(quaternion(2, 0), no_unit); // which no direction cosine contains
  EXPECT_EQ(quaternion(0, 1e200), no_unit);
}

TEST(builder_mistakes, looks_at_orientations_by_functions_of_angles) {
  const std::string no_unit = "the quaternion of frame A does not have unit length";
  const auto quaternion = [](auto e0, auto e3) {
    return told([&](auto& b) { b.quaternion("A", b.n, e0(b), b.number(0.0), b.number(0.0), e3(b)); });
  };
  const auto half_cosine = [](auto& b) { return cos(b.theta / 2); };
  const auto half_sine = [](auto& b) { return sin(b.theta / 2); };
  EXPECT_EQ(quaternion(half_cosine, half_sine), "");
  EXPECT_EQ(quaternion(half_cosine, [](auto& b) { return 2 * sin(b.theta / 2); }), no_unit);
  EXPECT_EQ(quaternion(half_cosine, [](auto& b) { return sin(b.theta); }), no_unit);
  EXPECT_EQ(quaternion([](auto& b) { return b.m; }, half_sine), ""); // if m is nonzero
  const auto turned = [](auto xx, auto yy) {
    return told([&](auto& b) {
      kanexpr::mechanics::matrix3 m = rows(b, {0, 0, 0, 0, 0, 0, 0, 0, 1});
      const expression c = cos(b.theta), s = sin(b.theta);
      m(0, 0) = xx(b, c), m(1, 1) = yy(b, c), m(1, 0) = s, m(0, 1) = -s;
      b.direction_cosines("A", b.n, m);
    });
  };
  const auto same = [](auto&, expression e) { return e; };
  EXPECT_EQ(turned(same, same), "");
  EXPECT_EQ(turned(same, [](auto&, expression e) { return -e; }),
            "the direction cosines of frame A are not orthonormal");
  EXPECT_EQ(turned([](auto&, expression e) { return 2 * e; }, same),
            "the direction cosines of frame A are not orthonormal");
  EXPECT_EQ(turned([](auto& b, expression e) { return b.m * e; }, same), "");
  EXPECT_EQ(turned([](auto& b, expression) { return 1 - b.theta * b.theta; }, same), "");
  EXPECT_EQ(told([](auto& b) {
              kanexpr::mechanics::matrix3 m = rows(b, {0, 0, 0, 0, 0, 0, 0, 0, 1});
              const expression c = cos(b.theta), s = sin(b.theta);
              m(0, 0) = c, m(1, 1) = -c, m(1, 0) = s, m(0, 1) = s;
              b.direction_cosines("A", b.n, m);
            }),
            "the direction cosines of frame A are not right-handed: they describe a reflection");
}

TEST(builder_mistakes, looks_at_masses_and_inertias) {
  const auto body = [](auto mass, auto inertia) {
    return told([&](auto& b) { b.rigid_body("A", b.bob, b.rod, mass(b), inertia(b)); });
  };
  const auto m = [](auto& b) { return b.m; };
  const auto of = [](std::initializer_list<double> numbers) {
    return [numbers](auto& b) {
      const double* i = numbers.begin();
      return b.inertia(b.rod, b.number(i[0]), b.number(i[1]), b.number(i[2]), b.number(i[3]), b.number(i[4]),
                       b.number(i[5]));
    };
  };
  EXPECT_EQ(body(m, of({1, 2, 3, 0, 0, 0})), "");          // a plate
  EXPECT_EQ(body(m, of({1, 1, 0, 0, 0, 0})), "");          // a rod
  EXPECT_EQ(body(m, of({1.23, 2.34, 3.58, 0, 0, 0})), ""); // a plate, rounded
  EXPECT_EQ(body(m, of({0, 0, 0, 0, 0, 0})), "");
  EXPECT_EQ(body(m, of({0, 0, 5, 0, 0, 0})), ""); // for a planar motion
  EXPECT_EQ(body(m, of({1e-9, 1e-9, 1e-9, 0.2e-9, 0, 0.1e-9})), "");
  const std::string none = "the inertia of A is not physical: one principal moment exceeds the sum of the "
                           "other two; if this is intended, wrap it in effective_inertia<...>";
  EXPECT_EQ(body(m, of({1, 2, 3.1, 0, 0, 0})), none);
  EXPECT_EQ(body(m, of({1e-9, 2e-9, 3.1e-9, 0, 0, 0})), none);
  EXPECT_EQ(body(m, of({2, 2, 2, 1.5, 0, 0})), none); // principal moments 0.5, 2 and 3.5
  EXPECT_EQ(body(m, of({2, 2, 2, 2.1, 0, 0})),
            "the inertia of A is indefinite: its moment about some axis is negative");
  EXPECT_EQ(body(m, [](auto& b) { return b.inertia(b.rod, b.m, -2 * b.m * b.length, b.m); }),
            "a moment of inertia of A is negative");
  for (int factor : {1, 2, 3})
    EXPECT_EQ(told([&](auto& b) { b.particle("A", b.bob, -factor * b.m); }), "the mass of A is negative");
  EXPECT_EQ(told([](auto& b) { b.particle("A", b.bob, -(b.m + b.length * b.m / 3)); }),
            "the mass of A is negative");
  EXPECT_EQ(told([](auto& b) { b.particle("A", b.bob, b.m - b.length); }), "");
  const auto about = [&](std::initializer_list<double> numbers) { // a point at (1, 2, 0) from the mass center
    return told([&](auto& b) {
      const point_id other = b.offset("Other", b.bob, b.along(b.rod, 1, 2, 0));
      b.rigid_body("A", b.bob, b.rod, b.number(2), of(numbers)(b), other);
    });
  };
  EXPECT_EQ(about({8, 2, 10, -4, 0, 0}), ""); // of the mass only
  EXPECT_EQ(about({9, 3, 11, -4, 0, 0}), "");
  EXPECT_EQ(about({7, 6, 10, -4, 0, 0}),
            "the inertia of A about Other is smaller than the parallel-axis term of its mass");
  EXPECT_EQ(about({9, 3, 14, -4, 0, 0}), none);
  EXPECT_EQ(about({0, 0, 10, 0, 0, 0}), ""); // for a planar motion
  EXPECT_EQ(about({0, 0, 9, 0, 0, 0}),
            "the inertia of A about Other is smaller than the parallel-axis term of its mass");
  const auto in_two_frames = [&](double product, double back, double third) {
    return told([&](auto& b) {
      const frame_id turned = b.rotated("T", b.rod, b.number(0.5), b.along(b.rod, 0, 0, 1));
      const frame_id same = b.rotated("U", turned, b.number(-0.5), b.along(b.rod, 0, 0, 1));
      kanexpr::mechanics::dyadic sum = of({2, 3, third, 0, 0, 0})(b);
      for (auto [left, right, entry] :
           {std::tuple(b.rod, same, product), std::tuple(same, b.rod, back), std::tuple(same, turned, 0.0)}) {
        kanexpr::mechanics::matrix3 value = rows(b, {0, 0, 0, 0, 0, 0, 0, 0, 0});
        (left == b.rod ? value(0, 1) : value(1, 0)) = b.number(entry);
        sum.add(static_cast<int>(left), static_cast<int>(right), value);
      }
      b.rigid_body("A", b.bob, b.rod, b.m, sum);
    });
  };
  EXPECT_EQ(in_two_frames(0.5, 0.5, 4), "");
  EXPECT_EQ(in_two_frames(0.5, 0.25, 4), "the inertia of A is not symmetric");
  EXPECT_EQ(in_two_frames(3, 3, 4), "the inertia of A is indefinite: its moment about some axis is negative");
  EXPECT_EQ(in_two_frames(0.5, 0.5, 9), none);
  EXPECT_EQ(body(m,
                 [](auto& b) {
                   kanexpr::mechanics::dyadic d = b.inertia(b.rod, b.m, b.m, b.m, b.m / 4, b.m / 8, b.m / 8);
                   d.parts[0].value(0, 1) = b.m / 3;
                   return d;
                 }),
            "the inertia of A is not symmetric");
  EXPECT_EQ(told([](auto& b) { b.potential_energy(1 / 2 * b.m * b.theta); }),
            "a potential energy contains an operation with the integer 0, which is also the value of 1/2 in "
            "C++; write x/2 or "
            "0.5*x, or 0.0 if you mean zero");
  EXPECT_EQ(told([](auto& b) { b.potential_energy(0.0 * b.m * b.theta); }), "a potential energy is zero");
  EXPECT_EQ(told([&](auto& b) {
              b.rigid_body("A", b.bob, b.rod, b.m, of({1, 2, 3.1, 0, 0, 0})(b));
              b.effective_inertia("A");
            }),
            "");
  EXPECT_EQ(told([](auto& b) { b.effective_inertia("B"); }),
            "effective_inertia refers to body B, which does not exist");
  const auto nothing = [](auto& b) { return b.number(0.0); };
  EXPECT_EQ(body(nothing, of({1, 2, 3, 0, 0, 0})), "");
  EXPECT_EQ(body(nothing, of({0, 0, 0, 0, 0, 0})), "body A has no mass");
}

TEST(builder_mistakes, looks_at_what_torsional_springs_turn) {
  EXPECT_EQ(told([](auto& b) { b.torsional_spring(b.theta, b.m); }), "");
  EXPECT_EQ(
      told([](auto& b) { b.torsional_spring(b.m, b.theta); }),
      "the angle of a torsional spring contains no coordinate; pass the angle first, then the stiffness");
  EXPECT_EQ(told([](auto& b) { b.torsional_spring(b.theta, b.m * b.x); }),
            "the stiffness of a torsional spring contains the coordinate x; it may contain only parameters, "
            "inputs and time");
}

TEST(builder_mistakes, looks_at_what_vanishes) {
  EXPECT_EQ(told([](auto& b) { b.configuration_constraint(b.zero_along(b.position_of(b.bob, b.o))); }),
            "zero_along of a configuration constraint requires at least one direction");
  EXPECT_EQ(told([](auto& b) {
              b.configuration_constraint(b.zero_along(b.position_of(b.bob, b.o), b.along(b.n, 0.0, 0, 0)));
            }),
            "a configuration constraint has a direction of zero length");
  EXPECT_EQ(told([](auto& b) { b.velocity_constraint(b.zero_along(b.along(b.n, b.v, 0, 0))); }),
            "zero_along of a velocity constraint requires at least one direction");
  EXPECT_EQ(told([](auto& b) { b.position_of(b.bob, point_id{9}); }),
            "a position refers to point number 9, which does not exist");
  EXPECT_EQ(told([](auto& b) { b.position_of(b.bob, b.origin("Bearing")); }),
            "the position of P from Bearing is not known: they are measured from two origins, O and Bearing");
  EXPECT_EQ(told([](auto& b) { b.dot(b.along(b.n, 1, 0, 0), pendulum_on_cart().along(b.n, 1, 0, 0)); }),
            "a dot product contains an expression that belongs to a different mechanism or to none");
}

TEST(builder_mistakes, looks_at_expressions_made_of_two_mechanisms_or_none) {
  constexpr const char* mixed =
      "a potential energy contains an expression that belongs to a different mechanism or to none";
  pendulum_on_cart other;
  EXPECT_EQ(told([&](auto& b) { b.potential_energy(b.x + other.x); }), mixed);
  EXPECT_EQ(told([&](auto& b) { b.potential_energy(sin(2 * (b.x * other.x)) - b.x); }), mixed);
  EXPECT_EQ(told([](auto& b) { b.potential_energy(b.x + kanexpr::symbolic::expression()); }), mixed);
}

TEST(builder_mistakes, tells_the_first_one) {
  EXPECT_EQ(told([](auto& b) {
              b.origin("P");
              b.gravity(b.along(frame_id{7}, 0, 0, 1));
            }),
            "two points are called P");
}

} // namespace
