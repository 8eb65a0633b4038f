// builds: sanitize
#include <models/spinning_top.hpp>

#include <gtest/gtest.h>

namespace {

using eom = kanexpr::equations_of_motion<spinning_top::System>;

constexpr auto all = eom::together(eom::mass_matrix, eom::forcing, eom::udot, eom::kinetic_energy);

constexpr int operations(const kanexpr::symbolic::cost& c) {
  return c.multiplications + c.additions + c.divisions;
}

static_assert(operations(all.cost()) <
              operations(eom::cost(eom::mass_matrix)) + operations(eom::cost(eom::forcing)) +
                  operations(eom::cost(eom::udot)) + operations(eom::cost(eom::kinetic_energy)));
static_assert(operations(all.cost()) >= operations(eom::cost(eom::udot)));
static_assert(all.cost().trigonometric == 1);

TEST(together, gives_the_bits_of_the_single_functions) {
  using namespace spinning_top;
  eom::state x;
  x[q1] = 0.3;
  x[q2] = 0.8;
  x[q3] = -1.1;
  x[u1] = 0.7;
  x[u2] = -2.5;
  x[u3] = 40;
  eom::parameters p;
  p[m] = 0.5;
  p[l] = 0.08;
  p[g] = 9.81;
  p[A] = 0.0009;
  p[C] = 0.0006;
  const auto [mass_matrix, forcing, udot, kinetic_energy] = all(x, p);
  EXPECT_EQ(mass_matrix, eom::mass_matrix(x, p));
  EXPECT_EQ(forcing, eom::forcing(x, p));
  EXPECT_EQ(udot, eom::udot(x, p));
  EXPECT_EQ(kinetic_energy, eom::kinetic_energy(x, p));
}

} // namespace
