// builds: g++
// The derivatives of a linkage's complete right-hand side with respect to its whole state.
#include "compiled/complex_steps.hpp"

#include <models/four_bar.hpp>

namespace {

using namespace four_bar;
using step_checks::point;

point<System> linkage() {
  point<System> at = step_checks::plain_point<System>();
  at.p[l0] = 2, at.p[l1] = 0.7, at.p[l2] = 1.8, at.p[l3] = 1.2;
  at.x[q1] = 0.9, at.x[q2] = -0.6, at.x[q3] = -1.2;
  return at;
}

TEST(jacobian_of_linkage, is_that_of_rhs) { step_checks::jacobian_is_that_of_rhs(linkage()); }
TEST(jacobian_of_linkage, reduces_to_the_linearization) { step_checks::reduces_to_explicit_form(linkage()); }

// A crank rotated to the position in which coupler and rocker are in line.
TEST(jacobian_of_linkage, tells_where_there_is_none) {
  point<System> at = step_checks::plain_point<System>();
  at.x[q1] = 0.3;
  const auto [by_state, by_inputs] = kanexpr::linearization<System>::jacobian(at.x, at.p, at.r);
  EXPECT_FALSE(by_state.status);
  EXPECT_EQ(by_inputs.status.cause(),
            "the constraints cannot be solved for the dependent speeds u2 and u3 at this state");
}

} // namespace
