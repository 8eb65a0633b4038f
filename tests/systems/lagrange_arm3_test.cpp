// builds: g++
#include "systems/check_lagrange.hpp"

#include <models/arm3.hpp>

namespace {

TEST(lagrange, arm3) {
  using namespace arm3;
  check::lagrange_against_kane<System, LagrangeSystem, true>(oracle::load("arm3_spatial").parameters, 3);
  check::lagrange_against_oracle<LagrangeSystem>("arm3_spatial");
}

} // namespace
