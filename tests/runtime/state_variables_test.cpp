// builds: clang++
// Models with state variables at run time: the same bits as compiled ones, from types and from a builder;
// units, linearizations, and mistakes in a builder.
#include "runtime/agreement.hpp"

#include <kanexpr/runtime/builder.hpp>
#include <kanexpr/runtime/values.hpp>
#include <kanexpr/units/si.hpp>
#include <models/motor_arm.hpp>

#include <string>
#include <vector>

namespace {

using namespace kanexpr;
using mechanics::quantity;
using runtime::builder;
using symbolic::expression;

/// The arm of motor_arm.hpp.
struct built_arm : builder {
  expression q = coordinate("q"), u = speed("u");
  expression i = state_variable("i"), f = state_variable("f"), e = state_variable("e");
  expression m = parameter("m"), l = parameter("l"), g = parameter("g"), n = parameter("n"),
             k = parameter("k"), R = parameter("R"), L = parameter("L"), kp = parameter("kp"),
             ki = parameter("ki"), tau = parameter("tau"), r = input("r");

  built_arm() : builder("N") {
    kinematic_equation(dot(q) - u);
    const auto N = inertial_frame(), A = rotated("A", N, q, along(N, 0, 0, 1));
    particle("Bob", offset("P", origin("O"), along(A, l, 0, 0)), m);
    gravity(along(N, g, 0, 0));
    torque(A, along(N, 0, 0, n * k * i));
  }
  void control() {
    dynamics(i, (kp * (f - q) + ki * e - R * i - n * k * u) / L);
    dynamics(f, (r - f) / tau);
    dynamics(e, f - q);
  }
};

TEST(state_variables_at_run_time, have_the_bits_of_compiled_ones) {
  agreement::check<motor_arm::System>();
  agreement::check<motor_arm::LagrangeSystem>();
}

TEST(state_variables_at_run_time, come_from_a_builder) {
  built_arm b;
  b.control();
  model built = derive(b);
  ASSERT_EQ(built.mistake(), "");
  auto rhs = built.function(built.rhs());
  std::mt19937_64 source(7);
  for (int round = 0; round < 20; ++round) {
    using eom = equations_of_motion<motor_arm::System>;
    const auto x = agreement::random<eom::state>(source, -2, 2);
    const auto p = agreement::random<eom::parameters>(source, 0.5, 2);
    const auto r = agreement::random<eom::inputs>(source, -2, 2);
    const auto expected = eom::rhs(x, p, r);
    EXPECT_LE((rhs(x, p, r) - expected).norm(), 1e-14 * expected.norm());
  }
  state<model> x(built);
  EXPECT_EQ(x.size(), 5);
  EXPECT_EQ(x.u().size(), 1);
  EXPECT_EQ(x.z().size(), 3);
  x["f"] = 2;
  EXPECT_EQ(x.z()(1), 2);
}

TEST(state_variables_at_run_time, are_linearized_about_points_by_name) {
  model arm = derive<motor_arm::System>();
  auto linear = arm.linearize({{"q", 0}, {"u", 0}, {"i", 0}, {"f", 0}, {"e", 0}, {"r", 0}});
  EXPECT_EQ(linear.states(), (std::vector<std::string>{"q", "u", "i", "f", "e"}));
  const auto [A, B] = linear.explicit_form();
  ASSERT_TRUE(linear) << linear.failures()[0];
  ASSERT_EQ(A.rows, 5);
  ASSERT_EQ(B.columns, 1);
  EXPECT_EQ(symbolic::print(A(1, 0)), "-g/l");
  EXPECT_EQ(symbolic::print(A(2, 2)), "-R/L");
  EXPECT_EQ(symbolic::print(A(3, 3)), "-1/tau");
  EXPECT_EQ(symbolic::print(A(4, 0)), "-1");
  EXPECT_EQ(symbolic::print(B(3, 0)), "1/tau");
  const auto outputs = linear.outputs(arm.measured_by<dot(motor_arm::i)>());
  EXPECT_EQ(symbolic::print(outputs.C(0, 2)), "-R/L");
}

TEST(state_variables_at_run_time, have_units) {
  model arm = derive<motor_arm::System>();
  const auto unit = [](const auto& u) { return std::string(text_of(u).view()); };
  EXPECT_EQ(unit(arm.units().of("e")), "s rad");
  EXPECT_EQ(unit(arm.units().of("f")), "rad");
  EXPECT_EQ(unit(arm.unit_of(quantity::udot, 1)), "A/s");
  EXPECT_EQ(unit(arm.unit_of(quantity::forcing, 0)), "N m");
  EXPECT_EQ(unit(arm.unit_of(quantity::forcing, 1)), "A/s");
  EXPECT_EQ(unit(arm.unit_of(quantity::forcing, 3)), "rad");
  EXPECT_EQ(unit(arm.unit_of(quantity::state_matrix, 3, 3)), "1/s");
  using namespace units::si;
  builder b("N");
  const auto q = b.coordinate("q", meter), u = b.speed("u"), z = b.state_variable("z", ampere);
  b.kinematic_equation(b.dot(q) - u);
  b.particle("Bob", b.offset("P", b.origin("O"), b.along(b.inertial_frame(), q, 0.0, 0.0)), b.number(1));
  b.dynamics(z, u);
  EXPECT_EQ(b.check().view(), "the dynamics of state variable z equates z' [A/s] and u [m/s]");
}

template <class Mistake>
std::string told(Mistake mistake) {
  built_arm b;
  mistake(b);
  return std::string(b.check().view());
}

TEST(state_variables_at_run_time, tell_mistakes) {
  EXPECT_EQ(told([](auto&) {}),
            "state variable i has no dynamics; write one equation, dynamics<dot(i) == rate>");
  EXPECT_EQ(told([](auto& b) {
              b.control();
              b.dynamics(b.f, b.r);
            }),
            "state variable f has two dynamics; write one equation, dynamics<dot(f) == rate>");
  EXPECT_EQ(told([](auto& b) { b.dynamics(b.q, b.r); }),
            "the first argument of dynamics is not a state variable");
  EXPECT_EQ(told([](auto& b) { b.dynamics(b.f, b.dot(b.f)); }),
            "the dynamics of state variable f do not determine its rate");
  EXPECT_EQ(told([](auto& b) { b.speed("w"); }),
            "a speed is declared after state variable e; declare state variables after all speeds");
  EXPECT_EQ(told([](auto& b) {
              b.control();
              b.potential_energy(b.i * b.q);
            }),
            "potential energy 1 contains the state variable i; it may contain only coordinates");
  EXPECT_EQ(told([](auto& b) { b.state_variable("u"); }), "the name u is used twice");
  EXPECT_EQ(told([](auto& b) { b.lag("", b.q, 0.1); }), "one of the blocks has no name");
  EXPECT_EQ(told([](auto& b) { b.control(), b.lag("F", b.q, -0.1); }),
            "the time constant of block F is not positive");
  EXPECT_EQ(told([](auto& b) { b.control(), b.pid("C", b.q, 1, 1, 5, -5, 0.1); }),
            "the distance between the limits of block C is not positive");
  EXPECT_EQ(told([](auto& b) { b.control(), b.dc_motor("M", b.u, {1.0, -1.0, 1.0, 1.0}); }),
            "the resistance of the motor M is not positive");
}

} // namespace
