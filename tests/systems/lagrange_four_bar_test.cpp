// builds: g++
#include "systems/check_lagrange.hpp"

#include <models/four_bar.hpp>

namespace {

TEST(lagrange, four_bar) {
  using namespace four_bar;
  const check::numbers values = oracle::load("four_bar").parameters;
  check::lagrange_against_kane<System, LagrangeSystem, true>(values, 0.8, 1e-11);
  check::keeps_its_energy<LagrangeSystem>(values, 0.8);
}

} // namespace
