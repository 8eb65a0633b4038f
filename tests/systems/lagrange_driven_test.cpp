// builds: clang++
#include "systems/check_lagrange.hpp"

#include <models/rocket.hpp>
#include <models/rotating_tube.hpp>
#include <models/spinning_top.hpp>

namespace {

// The contribution of a prescribed motion to the momenta.
TEST(lagrange, rotating_tube) {
  using namespace rotating_tube;
  check::lagrange_against_kane<System, LagrangeSystem, true>(oracle::load("rotating_tube").parameters, 2);
}

TEST(lagrange, rocket) {
  using namespace rocket;
  const check::numbers values = oracle::load("rocket_variable_mass").parameters;
  check::lagrange_against_kane<System, LagrangeSystem, true>(values, 2);
}

TEST(lagrange, spinning_top) {
  using namespace spinning_top;
  const check::numbers values = oracle::load("spinning_top").parameters;
  check::lagrange_against_kane<System, LagrangeSystem, false>(values, 1.4, 1e-11);
  check::keeps_its_energy<LagrangeSystem>(values, 1.4);
}

} // namespace
