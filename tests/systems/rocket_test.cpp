#include "systems/check_constrained.hpp"

#include <models/rocket.hpp>

namespace {

using namespace rocket;

TEST(rocket, agrees_with_the_oracle) { check::constrained_against_oracle<System>("rocket_variable_mass"); }

// In free flight, with the thrust of gas ejected at 3000 m/s.
TEST(rocket, follows_tsiolkovskys_equation) {
  using eom = kanexpr::equations_of_motion<System>;
  const double outflow = 3000;
  eom::parameters p;
  p[g] = 9.81;
  p[cd] = 0;
  for (const double speed : {-20.0, 0.0, 161.858434}) {
    eom::state x;
    x[q] = 13.436424;
    x[u] = speed;
    eom::inputs r;
    r[m] = 39.369858;
    r[dot(m)] = -2.234793;
    r[T] = (speed - outflow) * r[dot(m)]; // the momentum of the gas is that of the mass that is ejected
    const double expected = -outflow * r[dot(m)] / r[m] - p[g];
    EXPECT_NEAR(check::without_heap(eom::udot, x, p, r)(0), expected, 1e-12 * std::abs(expected));
  }
}

} // namespace
