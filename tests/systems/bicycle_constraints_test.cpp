// builds: g++
#include "systems/check_constrained.hpp"

#include <kanexpr/steps/assemble.hpp>
#include <models/bicycle.hpp>

namespace {

using namespace bicycle;
using eom = kanexpr::equations_of_motion<BoundSystem>;

TEST(bicycle, satisfies_its_constraints) { check::residuals_vanish<BoundSystem>("bicycle_whipple"); }

// From an upright position, with nonzero values only for the independent speeds.
TEST(bicycle, is_assembled) {
  const oracle::system reference = oracle::load("bicycle_whipple");
  for (const oracle::state& s : reference.states) {
    const auto expected = check::state_by_name<BoundSystem>(reference.q, s.q, reference.u, s.u);
    eom::state x = expected;
    x[q4] = x[u1] = x[u4] = x[u6] = 0;
    EXPECT_TRUE(kanexpr::assemble<BoundSystem>(x));
    EXPECT_TRUE(oracle::close(x, expected, 1e-13));
  }
}

} // namespace
