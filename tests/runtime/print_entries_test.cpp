// builds: clang++
#include "runtime/cart_with_units.hpp"
#include "simulations/falling_ball.hpp"

#include <kanexpr/runtime/latex_symbols.hpp>
#include <kanexpr/runtime/print_entries.hpp>
#include <kanexpr/symbolic.hpp>

#include <gtest/gtest.h>

#include <string>

namespace {

using namespace kanexpr;
using mechanics::quantity;

TEST(print_entries, writes_units) {
  model cart = derive(cart_with_units());
  ASSERT_EQ(cart.mistake(), "");
  EXPECT_EQ(print_entries(cart, quantity::mass_matrix), "mass_matrix(v, v) = 3*m  [kg]\n"
                                                        "mass_matrix(v, u) = l*m*cos(q)  [kg m]\n"
                                                        "mass_matrix(u, v) = l*m*cos(q)  [kg m]\n"
                                                        "mass_matrix(u, u) = l^2*m  [kg m²]\n");
  EXPECT_EQ(print_entries(cart, quantity::qdot), "qdot(s) = v  [m/s]\nqdot(q) = u  [rad/s]\n");
  EXPECT_EQ(print_entries(cart, quantity::center_of_mass),
            "center_of_mass(0) = l*cos(q)/3  [m]\ncenter_of_mass(1) = (2*m*s + m*(l*sin(q) + s))/(3*m)  [m]\n"
            "center_of_mass(2) = 0  [m]\n");
  EXPECT_EQ(print_entries(cart, quantity::potential_energy), "potential_energy = -g*l*m*cos(q)  [J]\n");
}

TEST(print_entries, names_common_parts_of_a_long_text) {
  model cart = derive(cart_with_units());
  const std::string text = print_entries(cart, quantity::udot, 0);
  EXPECT_TRUE(text.starts_with("udot(v) = ")) << text;
  EXPECT_NE(text.find("  [m/s²]\nudot(u) = "), std::string::npos) << text;
  EXPECT_NE(text.find("  [rad/s²]\nwhere\n  z1 = "), std::string::npos) << text;
  EXPECT_TRUE(text.ends_with('\n'));
  EXPECT_EQ(print_entries(cart, quantity::udot).find("where"), std::string::npos);
}

TEST(print_entries, writes_none_of_a_model_that_states_none) {
  model ball = derive<falling_ball::System>();
  EXPECT_EQ(print_entries(ball, quantity::forcing), "forcing(v) = -g*m\n");
  EXPECT_EQ(print_entries(ball, quantity::multipliers), "");
}

TEST(latex_symbols, writes_units) {
  const model cart = derive(cart_with_units());
  EXPECT_EQ(latex_symbols(cart), R"($s$ & coordinate & $\mathrm{m}$ \\
$q$ & coordinate & $\mathrm{rad}$ \\
$v$ & speed & $\mathrm{m/s}$ \\
$u$ & speed & $\mathrm{rad/s}$ \\
$m$ & parameter & $\mathrm{kg}$ \\
$l$ & parameter & $\mathrm{m}$ \\
$g$ & parameter & $\mathrm{m/s^{2}}$ \\
$k$ & parameter & $\mathrm{N/m}$ \\
$c$ & parameter & $\mathrm{N\,m\,s/rad}$ \\
$w$ & parameter & \\
$F$ & input & $\mathrm{N}$ \\
)");
}

TEST(latex_symbols, writes_no_units_of_a_model_that_states_none) {
  const model ball = derive<falling_ball::System>();
  const std::string text = latex_symbols(ball);
  EXPECT_NE(text.find("$v$ & speed \\\\\n"), std::string::npos) << text;
  EXPECT_EQ(text.find("mathrm"), std::string::npos);
}

} // namespace
