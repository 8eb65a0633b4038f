// builds: clang++
// Systems with state variables, by both methods and with constraints, compared with hand-written equations
// and with complex-step differentiation.
#include "compiled/complex_steps.hpp"
#include "compiled/stirred_slider.hpp"

#include <models/motor_arm.hpp>

#include <cmath>

namespace {

TEST(state_variables, move_as_written) {
  using namespace motor_arm;
  using eom = kanexpr::equations_of_motion<System>;
  static_assert(eom::coordinates == 1 && eom::speeds == 4 && eom::state_variables == 3);
  static_assert(eom::state::SizeAtCompileTime == 5);
  std::mt19937_64 source(1);
  for (int round = 0; round < 20; ++round) {
    const auto at = step_checks::random_point(source, step_checks::plain_point<System>(), 1);
    const auto& p = at.p;
    const auto& x = at.x;
    const double inertia = p[m] * p[l] * p[l];
    const double volts = p[kp] * (x[filtered] - x[q]) + p[ki] * x[integral];
    Eigen::Vector<double, 5> expected;
    expected << x[u], (p[n] * p[k] * x[i] - p[m] * p[g] * p[l] * std::sin(x[q])) / inertia,
        (volts - p[R] * x[i] - p[n] * p[k] * x[u]) / p[L], (at.r[reference] - x[filtered]) / p[tau],
        x[filtered] - x[q];
    const auto found = eom::rhs(x, p, at.r);
    EXPECT_LE((found - expected).norm(), 1e-14 * expected.norm());
    const auto by_lagrange =
        kanexpr::equations_of_motion<LagrangeSystem>::rhs(x.eval(), p.eval(), at.r.eval());
    EXPECT_LE((by_lagrange - expected).norm(), 1e-14 * expected.norm());
    EXPECT_EQ(x.q()(0), x[q]);
    EXPECT_EQ(x.u().size(), 1);
    EXPECT_EQ(x.u()(0), x[u]);
    EXPECT_EQ(x.z(), x.tail<3>());
  }
}

// M has a 1 on the diagonal for each state variable, and f contains its rate.
TEST(state_variables, are_further_unknowns) {
  using namespace motor_arm;
  using eom = kanexpr::equations_of_motion<System>;
  std::mt19937_64 source(2);
  const auto at = step_checks::random_point(source, step_checks::plain_point<System>(), 1);
  Eigen::Matrix4d mass = Eigen::Matrix4d::Identity();
  mass(0, 0) = at.p[m] * at.p[l] * at.p[l];
  EXPECT_LE((eom::mass_matrix(at.x, at.p, at.r) - mass).norm(), 1e-15 * mass.norm());
  EXPECT_LE((eom::forcing(at.x, at.p, at.r).tail<3>() - eom::udot(at.x, at.p, at.r).tail<3>()).norm(), 1e-15);
  EXPECT_EQ(eom::kinetic_energy(at.x, at.p), mass(0, 0) * at.x[u] * at.x[u] / 2);
}

TEST(state_variables, have_derivatives) {
  step_checks::jacobian_is_that_of_rhs<motor_arm::System>();
  step_checks::jacobian_is_that_of_rhs<stirred_slider::FreeSystem>();
  step_checks::jacobian_is_that_of_rhs<stirred_slider::LagrangeSystem>();
}

TEST(state_variables, are_linearized_with_constraints) {
  using namespace stirred_slider;
  auto around = step_checks::plain_point<System>();
  around.x[q] = 0.7;
  const auto [A, B] = kanexpr::linearization<System>::explicit_form(around.t, around.x, around.p, around.r);
  EXPECT_EQ(A.rows(), 4);
  EXPECT_EQ(B.rows(), 4);
  step_checks::reduces_to_explicit_form<System>(around);
  auto as_well = step_checks::plain_point<LagrangeSystem>();
  as_well.x[q] = 0.7;
  step_checks::reduces_to_explicit_form<LagrangeSystem>(as_well);
}

// Kane's and Lagrange's methods agree where the constraint holds.
TEST(state_variables, are_those_of_both_methods) {
  using namespace stirred_slider;
  std::mt19937_64 source(4);
  auto around = step_checks::plain_point<System>();
  around.x[q] = 0.7;
  for (int round = 0; round < 20; ++round) {
    auto at = step_checks::random_point(source, around, 0.3);
    ASSERT_TRUE(kanexpr::assemble<System>(at.x, at.p, at.r, at.t));
    const auto by_kane = kanexpr::equations_of_motion<System>::rhs(at.t, at.x, at.p, at.r);
    const auto by_lagrange =
        kanexpr::equations_of_motion<LagrangeSystem>::rhs(at.t, at.x.eval(), at.p.eval(), at.r.eval());
    ASSERT_TRUE(by_kane.status && by_lagrange.status);
    EXPECT_LE((by_kane - by_lagrange).norm(), 1e-12 * by_kane.norm());
  }
}

// The rate of a state variable as an output.
TEST(state_variables, have_rates_in_outputs) {
  using namespace motor_arm;
  std::mt19937_64 source(6);
  const auto at = step_checks::random_point(source, step_checks::plain_point<System>(), 1);
  const auto [rate, power] = kanexpr::function<System, dot(i), voltage * i>{}(at.x, at.p, at.r);
  EXPECT_EQ(rate, kanexpr::equations_of_motion<System>::rhs(at.x, at.p, at.r)(2));
  EXPECT_NEAR(power, (at.p[kp] * (at.x[filtered] - at.x[q]) + at.p[ki] * at.x[integral]) * at.x[i], 1e-14);
}

TEST(state_variables, start_at_zero_if_omitted) {
  using namespace motor_arm;
  using values = kanexpr::state<System>;
  const values x{{q, 1}, {u, 2}, {i, 3}};
  EXPECT_EQ(x.mistake().view(), "");
  EXPECT_EQ(x.z()(0), 3);
  EXPECT_EQ(x.z().tail(x.z().size() - 1).norm(), 0);
  EXPECT_EQ((values{{q, 1}}.mistake().view()), "speed u has no value");
}

TEST(state_variables, are_named_in_sentences) {
  using namespace motor_arm;
  using values = kanexpr::state<System>;
  EXPECT_EQ((values{{q, 1}, {u, 0}, {i, 2}, {i, 3}}.mistake().view()), "state variable i has two values");
  EXPECT_EQ((values{{"q", 1}, {"w", 0}}.mistake().view()),
            "System has no coordinate, speed or state variable w");
}

} // namespace
