// builds: clang++
// Linearizations of Lagrange's equations, compared with complex steps at random operating points that satisfy
// the constraints, and with Kane's method if its speeds are the rates of the same coordinates.
#include "systems/linearized.hpp"

#include <models/chaplygin_sleigh.hpp>
#include <models/four_bar.hpp>
#include <models/n_pendulum_cart.hpp>
#include <models/pendulum_nonminimal.hpp>
#include <models/rotating_tube.hpp>

namespace {

using check::VectorXd;

TEST(linearization_by_lagrange, four_bar) {
  check::linearize<four_bar::LagrangeSystem>().against_complex_steps(
      "four_bar", VectorXd{{0.9, -0.6, -1.2, 0, 0, 0}}, 0.5);
}
TEST(linearization_by_lagrange, chaplygin_sleigh) {
  check::linearize<chaplygin_sleigh::LagrangeSystem>().against_complex_steps(
      "chaplygin_sleigh", VectorXd{{0, 0, 0.7, 0, 0, 0}}, 0.6);
}
TEST(linearization_by_lagrange, rotating_tube) {
  check::linearize<rotating_tube::LagrangeSystem>().against_complex_steps("rotating_tube", VectorXd::Zero(2),
                                                                          3);
}

// Both at the same states, which satisfy the constraints.
template <class Kane, class Lagrange>
void agree(const VectorXd& around) {
  check::linearized kane = check::linearize<Kane>(), lagrange = check::linearize<Lagrange>();
  ASSERT_EQ(kane.functions().states, lagrange.functions().states);
  std::srand(3);
  for (int round = 0; round < 50; ++round) {
    VectorXd x = around + VectorXd::Random(around.size()) / 3;
    const VectorXd p = VectorXd::Constant(static_cast<Eigen::Index>(kane.functions().p.size()), 1) +
                       VectorXd::Random(static_cast<Eigen::Index>(kane.functions().p.size())) / 2,
                   r = VectorXd::Random(static_cast<Eigen::Index>(kane.functions().r.size()));
    ASSERT_TRUE(kane.assemble(0, x, p, r));
    const check::explicit_form one = kane.at(0, x, p, r), other = lagrange.at(0, x, p, r);
    EXPECT_LE((one.A - other.A).norm(), 1e-11 * one.A.norm());
    EXPECT_LE((one.B - other.B).norm(), 1e-11 * (1 + one.B.norm()));
  }
}

TEST(linearization_by_lagrange, agrees_with_kane_on_a_pendulum_on_a_string) {
  agree<pendulum_nonminimal::System, pendulum_nonminimal::LagrangeSystem>(VectorXd{{0, 1, 0, 0}});
}
TEST(linearization_by_lagrange, agrees_with_kane_on_pendulums_on_a_cart) {
  agree<n_pendulum_cart::System<4>, n_pendulum_cart::LagrangeSystem<4>>(VectorXd::Zero(10));
}

// With the multipliers among the unknowns.
TEST(linearization_by_lagrange, has_rows_for_multipliers) {
  auto model = kanexpr::derive<four_bar::LagrangeSystem>();
  EXPECT_EQ(model.get(check::quantity::implicit_mass_matrix).rows, 8);
  EXPECT_EQ(model.get(check::quantity::implicit_state_matrix).columns, 2);
}

// If the loop cannot be closed by the dependent coordinates, the form with all equations also reports this.
TEST(linearization_by_lagrange, is_checked_in_full) {
  auto model = kanexpr::derive<four_bar::LagrangeSystem>();
  const auto state = model.get(check::quantity::implicit_state_matrix);
  bool of_coordinates = false;
  for (const auto& check :
       model.equations().singularity_checks_of(kanexpr::symbolic::nodes_of(state.entries)))
    if (check.cause.view().find("dependent coordinates q2 and q3") != std::string_view::npos)
      of_coordinates = true;
  EXPECT_TRUE(of_coordinates);
}

} // namespace
