// builds: g++
#include "systems/check_lagrange.hpp"

#include <models/chaplygin_sleigh.hpp>

namespace {

TEST(lagrange, chaplygin_sleigh) {
  using namespace chaplygin_sleigh;
  const check::numbers values = oracle::load("chaplygin_sleigh").parameters;
  check::lagrange_against_kane<System, LagrangeSystem, false>(values, 1);
  check::keeps_its_energy<LagrangeSystem>(values, 1);
}

} // namespace
