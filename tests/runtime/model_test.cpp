// builds: clang++ sanitize
// Printed results of a system derived at run time.
#include "models/rolling_disc.hpp"

#include <kanexpr/runtime/assemble.hpp>
#include <kanexpr/symbolic.hpp>

#include <gtest/gtest.h>

#include <cmath>

using namespace rolling_disc;

TEST(model, prints_results) {
  auto derived = derive<System>();
  EXPECT_EQ(derived.mistake(), "");
  const auto mass = derived.mass_matrix();
  EXPECT_EQ(symbolic::print(mass(0, 0)), "5*m*r^2/4");
  EXPECT_EQ(symbolic::print(mass(1, 1)), "3*m*r^2/2");
  EXPECT_EQ(symbolic::print(mass(2, 2)), "m*r^2/4");
  EXPECT_EQ(symbolic::print(mass(0, 1)), "0");
  EXPECT_EQ(symbolic::latex(mass(1, 1)), R"(\frac{3 m r^{2}}{2})");
  EXPECT_EQ(symbolic::print(derived.qdot()(0, 0)), "u3/cos(q2)");
}

TEST(model, prints_vectors_with_the_names_of_frames) {
  auto derived = derive<System>();
  EXPECT_EQ(derived.print(derived.vector<velocity_of<Dmc>>()), "r*u2*L.x - r*u1*L.y");
  EXPECT_EQ(derived.print(derived.vector<velocity_of<Dmc>>(), mechanics::basis_style::one_two_three),
            "r*u2*L.1 - r*u1*L.2");
  EXPECT_EQ(derived.print(derived.vector<velocity_of<Dmc>>(), mechanics::basis_style::ijk),
            "r*u2*L.i - r*u1*L.j");
  EXPECT_EQ(derived.print(derived.vector<partial(velocity_of<Dmc>, u1)>()), "-r*L.y");
  EXPECT_EQ(derived.print(derived.vector<angular_velocity_of<R>>()), "u1*L.x + u2*L.y + u3*L.z");
  EXPECT_EQ(derived.print(derived.vector<position_of<Dmc, C>>()), "r*L.z");
}

TEST(model, generalized_forces_add_up_to_the_equations) {
  auto derived = derive<System>();
  const state<System> x = state<System>::Constant(0.4);
  const parameter_values<System> p(2, 0.5, 9.81);
  const Eigen::Vector3d a = derived.function(derived.udot())(x, p);
  auto active = derived.function(derived.get(mechanics::quantity::active_forces));
  auto inertia = derived.function(derived.get(mechanics::quantity::inertia_forces));
  const Eigen::Vector3d sum = active(x, p) + inertia(0.0, x, p, p, a);
  EXPECT_LT(sum.norm(), 1e-13 * active(x, p).norm());
}

TEST(model, goes_on_after_a_request_that_makes_no_sense) {
  auto derived = derive<System>();
  EXPECT_TRUE(derived.vector<speed<"w">{} * N::x>().parts.empty());
  EXPECT_NE(derived.mistake(), "");
  EXPECT_EQ(symbolic::print(derived.mass_matrix()(0, 0)), "5*m*r^2/4");
  EXPECT_EQ(derived.mistake(), "");
  EXPECT_EQ(derived.get<speed<"w">{} * u1>().entries.size(), 0);
  EXPECT_EQ(derived.mistake(), "speed w, which an expression contains, is not in the list of speeds");
  EXPECT_EQ(derived.measured_by<speed<"w">{} * u1>().entries.size(), 0);
  EXPECT_NE(derived.mistake(), "");
  EXPECT_EQ(derived.get<u2 * u1>().entries.size(), 1);
  EXPECT_EQ(derived.mistake(), "");
  EXPECT_FALSE(derived.linearize({{q1, speed<"w">{} * u1}}));
  EXPECT_EQ(derived.mistake(), "");
}

struct Late : offset<Late, Dmc, parameter<"late">{} * u1 * L::x> {};

TEST(model, keeps_nothing_of_what_it_refuses) {
  auto derived = derive<System>();
  EXPECT_EQ(derived.get<velocity_of<Late>>().entries.size(), 0);
  EXPECT_NE(derived.mistake(), "");
  EXPECT_EQ(derived.mechanism().parameters.size(), 3);
  EXPECT_EQ(derived.get<velocity_of<Dmc>>().entries.size(), 3);
  EXPECT_EQ(derived.mistake(), "");
}

TEST(model, says_what_is_no_scalar_and_no_vector) {
  auto derived = derive<System>();
  EXPECT_EQ(derived.get<outer(L::x, L::y)>().entries.size(), 0);
  EXPECT_EQ(derived.mistake(), "a function requests a dyadic; it must request a scalar or a vector");
  EXPECT_TRUE(derived.vector<q1 * u1>().parts.empty());
  EXPECT_EQ(derived.mistake(), "the expression requested as a vector is not a vector");
}

TEST(model, evaluates_no_expression_of_another) {
  auto derived = derive<System>(), other = derive<System>();
  auto mass = derived.function(other.mass_matrix());
  EXPECT_EQ(mass(state<System>::Zero().eval(), parameter_values<System>(1, 1, 1)).size(), 0);
  EXPECT_EQ(mass.status().cause(), "the result to be evaluated belongs to a different model");
}

TEST(model, tells_in_the_status_why_a_result_was_not_formed) {
  auto derived = derive<System>();
  const symbolic::matrix refused = derived.get<speed<"w">{} * u1>();
  auto now = derived.function(refused);
  derived.mass_matrix(); // clears the rejected request
  auto later = derived.function(refused);
  for (auto* f : {&now, &later})
    EXPECT_EQ((*f)(state<System>::Zero().eval(), parameter_values<System>(1, 1, 1)).size(), 0);
  EXPECT_EQ(now.status().cause(), "speed w, which an expression contains, is not in the list of speeds");
  EXPECT_EQ(later.status().cause(), "the result to be evaluated was not formed");
}

TEST(model, tells_in_the_status_what_was_not_given) {
  auto derived = derive<System>();
  auto mass = derived.function(derived.mass_matrix());
  EXPECT_TRUE(std::isnan(mass(state<System>::Zero().eval())(0, 0)));
  EXPECT_EQ(mass.status().cause(), "the parameter vector has 0 entries, but none for r");
}

constexpr coordinate<"x"> position;
constexpr parameter<"kappa"> pull;
struct ByLagrangian : lagrange_system<inertial<N>, coordinates<position>,
                                      lagrangian<pow(dot(position), 2) / 2 - pull * position>> {};

TEST(model, of_a_whole_lagrangian_goes_on_after_an_energy_was_asked_for) {
  auto derived = derive<ByLagrangian>();
  const auto refused = "energies, momenta, the mass center and the regressor require bodies; a system given "
                       "by a Lagrangian has none";
  EXPECT_EQ(derived.get(mechanics::quantity::kinetic_energy).entries.size(), 0);
  EXPECT_EQ(derived.mistake(), refused);
  EXPECT_EQ(symbolic::print(derived.udot()), "[-kappa]");
  EXPECT_EQ(derived.mistake(), "");
  EXPECT_EQ(derived.get<mechanics::quantity::potential_energy>().entries.size(), 0);
  EXPECT_EQ(derived.mistake(), refused);
  EXPECT_TRUE(derived.linearize({{position, 0}, {dot(position), 0}, {pull, 0}}));
  EXPECT_EQ(symbolic::print(derived.mass_matrix()), "[1]");
}

struct WithoutBodies : kane_system<inertial<N>, coordinates<q1>, speeds<u1>, kinematics<dot(q1) == u1>> {};

TEST(model, of_a_system_with_a_mistake_has_results_without_entries) {
  auto derived = derive<WithoutBodies>();
  EXPECT_NE(derived.mistake(), "");
  EXPECT_EQ(derived.mass_matrix().entries.size(), 0);
  EXPECT_EQ(derived.get<q1 * u1>().entries.size(), 0);
  EXPECT_EQ(derived.measured_by<q1 * u1>().entries.size(), 0);
  EXPECT_EQ(symbolic::print(derived.imposed(derived.mechanism().one())), "1");
  EXPECT_TRUE(derived.imposed(mechanics::vector()).parts.empty());
  auto mass = derived.function(derived.mass_matrix());
  EXPECT_EQ(mass(Eigen::VectorXd::Zero(2)).size(), 0);
  EXPECT_EQ(mass.status().cause(), derived.mistake());
  Eigen::VectorXd x = Eigen::VectorXd::Zero(2);
  EXPECT_EQ(assemble(derived, x).cause(), derived.mistake());
  EXPECT_EQ(check_consistency(derived, x, x, x).cause(), derived.mistake());
}

TEST(model, is_assembled_from_whole_states) {
  auto derived = derive<System>();
  Eigen::VectorXd x = Eigen::VectorXd::Zero(2);
  EXPECT_EQ(assemble(derived, x).cause(), "the state vector of the model has 6 entries, not 2");
  EXPECT_EQ(check_consistency(derived, x, x, x).cause(),
            "the state vector of the model has 6 entries, not 2");
}
