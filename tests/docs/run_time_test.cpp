// builds: clang++
// Derivation at run time: docs/guide/run-time.md and docs/guide/builder.md.
#include "docs/printed.hpp"
#include "models/double_pendulum.hpp"
#include "models/rolling_disc_constrained.hpp"
#include "models/simple_pendulum.hpp"

#include <kanexpr/algebra.hpp>
#include <kanexpr/mechanics/equations.hpp>
#include <kanexpr/mechanics/motion/observe.hpp>
#include <kanexpr/runtime/assemble.hpp>
#include <kanexpr/runtime/builder.hpp>
#include <kanexpr/runtime/latex_symbols.hpp>
#include <kanexpr/runtime/listing.hpp>
#include <kanexpr/runtime/print_entries.hpp>
#include <kanexpr/symbolic.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <string>

namespace {

using namespace kanexpr;

namespace disc {

using namespace rolling_disc_constrained;

TEST(run_time, prints_a_model) {
  const docs::printed here;
#include <docs/guide/run-time/model.cpp>
  EXPECT_NE(here.text(), "");
}

TEST(run_time, shows_the_steps) {
#include <docs/guide/run-time/steps.cpp>
  EXPECT_EQ(model.mistake(), "");
  EXPECT_EQ(model.names_of_dependent_speeds(), "u4 and u5");
  EXPECT_EQ(model.print(model.vector<velocity_of<Dmc>>()), "u4*N.x + u5*N.y - r*u1*sin(q2)*N.z");
  EXPECT_EQ(model.print(model.vector<partial(velocity_of<Dmc>, u4)>()), "N.x");
  EXPECT_EQ(symbolic::print(model.qdot()),
            "[u3/cos(q2)             ]\n[u1                     ]\n"
            "[u2 - u3*sin(q2)/cos(q2)]\n[u4                     ]\n[u5                     ]");
  EXPECT_TRUE(udot.status());
}

} // namespace disc

TEST(run_time, names_parts_of_long_expressions) {
  const docs::printed here;
#include <docs/guide/run-time/parts.cpp>
  const std::string text = here.text();
  EXPECT_TRUE(text.starts_with("u' = [z6              ]\n     [z4*z5 - z3*z6*z5]\nwhere\n"
                               "  z1 = d2*m2*sin(q1 + q2)\n  z2 = d2*m2*cos(q1 + q2)\n"
                               "  z3 = l1*sin(q1)*z1 + l1*cos(q1)*z2\n"
                               "  z4 = T2 - c2*(u2 - u1) - l1*u1^2*cos(q1)*z1 - z2*(g - l1*u1^2*sin(q1))\n"
                               "  z5 = 1/(I2 + d2^2*m2)\n  z6 = "))
      << text;
}

TEST(run_time, has_other_forms) {
  symbolic::graph graph;
  const auto symbol = [&](symbolic::symbol_kind kind, const char* name) {
    return symbolic::variable(graph, {kind, base::name(name), 0});
  };
  const auto q1 = symbol(symbolic::symbol_kind::coordinate, "q1"),
             u1 = symbol(symbolic::symbol_kind::speed, "u1");
  const auto e = u1 * (sin(q1) + u1), a = e, b = u1 * sin(q1) + u1 * u1;
#include <docs/guide/run-time/forms.cpp>
  EXPECT_EQ(compare(a, b), equality::equal);
}

TEST(run_time, lists_operations) {
  const docs::printed here;
  auto pendulum = derive<simple_pendulum::System>();
#include <docs/guide/run-time/listing.cpp>
  EXPECT_EQ(here.text(), "t1 = u * c\nt2 = T - t1\nt3 = m * l\ns1 = sin(q)\n"
                         "t4 = g * s1\nt5 = t3 * t4\nt6 = t2 - t5\nforcing = t6\n");
#include <docs/guide/run-time/entries.cpp>
  EXPECT_NE(here.text().find("mass_matrix(u, u) = l^2*m"), std::string::npos);
#include <docs/guide/run-time/symbols.cpp>
  EXPECT_NE(here.text().find("$q$ & coordinate & $\\mathrm{rad}$ \\\\\n"), std::string::npos);
}

TEST(builder, makes_a_pendulum) {
  const docs::printed here;
#include <docs/guide/builder/pendulum.cpp>
  EXPECT_EQ(here.text(), "[-g*l*m*sin(q)]\n");
#include <docs/guide/builder/one.cpp>
  EXPECT_NEAR(numbers(0), -0.5 * std::cos(0.3), 1e-15);
  EXPECT_NEAR(numbers(1), -9.81 / 0.5 * std::sin(0.3), 1e-14);
}

TEST(builder, has_blocks) {
  runtime::builder b("N");
  const auto q = b.coordinate("q"), u = b.speed("u"), r = b.input("r"), kp = b.parameter("kp");
  b.kinematic_equation(b.dot(q) - u);
  const auto N = b.inertial_frame(), A = b.rotated("A", N, q, b.along(N, 0, 0, 1));
  const auto O = b.origin("O");
  b.rigid_body("Wheel", O, A, b.number(1), b.inertia(A, 1, 1, 1));
  const auto V = b.input("V");
#include <docs/guide/builder/blocks.cpp>
#include <docs/guide/builder/dc_motor.cpp>
  model controlled_wheel = derive(b);
  EXPECT_EQ(controlled_wheel.mistake(), "");
  EXPECT_EQ(controlled_wheel.udot().rows, 1 + 1 + 4 + 2 + 1 + 1);
  EXPECT_EQ(b.mechanism().speeds.find(motor.current), 9);
}

TEST(builder, makes_a_sleigh) {
  runtime::builder b("N");
  const auto x = b.coordinate("x"), y = b.coordinate("y"), turned = b.coordinate("turned");
  const auto u = b.speed("u"), v_y = b.speed("v"), w = b.speed("w"), zero = b.number(0.0);
  b.kinematic_equation(b.dot(x) - u);
  b.kinematic_equation(b.dot(y) - v_y);
  b.kinematic_equation(b.dot(turned) - w);
  const auto ground = b.inertial_frame();
  const auto sleigh = b.rotated("Sleigh", ground, turned, b.along(ground, 0, 0, 1));
  const auto o = b.origin("O"), blade = b.offset("Blade", o, b.along(ground, x, y, zero));
  const auto center = b.offset("G", blade, b.along(sleigh, 1, 0, 0));
  b.rigid_body("Body", center, sleigh, b.number(2), b.inertia(sleigh, zero, zero, b.number(1)));
#include <docs/guide/builder/sleigh.cpp>
  EXPECT_EQ(constrained.mistake(), "");
  EXPECT_EQ(constrained.mass_matrix().rows, 2);
#include <docs/guide/builder/tension.cpp>
  EXPECT_EQ((b.check)().view(), "");
  EXPECT_EQ(pull, 20.0 * (sqrt(x * x + y * y) - 0.1));
}

struct slider_crank : runtime::builder {
  symbolic::expression q1 = coordinate("q1"), q2 = coordinate("q2"), s = coordinate("s");
  symbolic::expression crank = number(0.1), rod = number(0.3);
  runtime::frame_id ground = inertial_frame();
  runtime::point_id o = origin("O"), slider = offset("S", o, along(ground, s, 0, 0)), end_of_rod;

  slider_crank() : builder("N") {
    kinematic_equation(dot(q1) - speed("u1"));
    kinematic_equation(dot(q2) - speed("u2"));
    kinematic_equation(dot(s) - speed("v"));
    const auto A = rotated("A", ground, q1, along(ground, 0, 0, 1)),
               B = rotated("B", ground, q2, along(ground, 0, 0, 1));
    end_of_rod = offset("Q", offset("P", o, along(A, crank, 0, 0)), along(B, rod, 0, 0));
    particle("Slider", slider, number(3));
    dependent(q2);
    dependent(s);
  }
};

void expect_closed(slider_crank& b) {
  EXPECT_EQ(b.check().view(), "");
  Eigen::VectorXd x(6);
  x << 0.7, -0.2, 0.3, 5, 0, 0;
  model closed = derive(b);
  ASSERT_TRUE(assemble(closed, x, Eigen::VectorXd(), Eigen::VectorXd()));
  EXPECT_NEAR(x(2), 0.1 * std::cos(0.7) + std::sqrt(0.09 - std::pow(0.1 * std::sin(0.7), 2)), 1e-14);
}

TEST(builder, closes_a_loop) {
  slider_crank b;
  const auto ground = b.ground;
  const auto end_of_rod = b.end_of_rod, slider = b.slider;
#include <docs/guide/builder/loop.cpp>
  expect_closed(b);
}

TEST(builder, closes_a_loop_by_hand) {
  slider_crank b;
  const auto q1 = b.q1, q2 = b.q2, s = b.s, crank = b.crank, rod = b.rod;
#include <docs/guide/builder/loop_by_hand.cpp>
  expect_closed(b);
}

} // namespace
