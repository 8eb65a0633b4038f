// builds: clang++
// Assembles four-bar linkages in single precision, as on a controller.
#include "no_heap.hpp"
#include "runtime/four_bars.hpp"

#include <kanexpr/assemble.hpp>

#include <gtest/gtest.h>

namespace {

using System = four_bars::System;

TEST(assemble_float, satisfies_the_constraints_to_its_rounding) {
  four_bars whole;
  kanexpr::state<System, float> x(whole.x.cast<float>());
  const kanexpr::parameter_values<System, float> p(whole.p.cast<float>());
  const kanexpr::input_values<System, float> r(whole.r.cast<float>());
  const auto before = kanexpr::check_consistency<System>(x, p, r);
  EXPECT_FALSE(before);
  EXPECT_TRUE(before.cause().starts_with("configuration constraint 1 has a residual of ")) << before.cause();

  const auto made = [&] {
    no_heap::guard guard;
    return kanexpr::assemble<System>(x, p, r);
  }();
  ASSERT_TRUE(made) << made.cause();
  EXPECT_TRUE(kanexpr::check_consistency<System>(x, p, r))
      << kanexpr::check_consistency<System>(x, p, r).cause();
  ASSERT_TRUE(kanexpr::assemble<System>(whole.x, whole.p, whole.r));
  EXPECT_LE((x.cast<double>() - whole.x).norm(), 2e-6 * whole.x.norm());
}

TEST(assemble_float, says_why_it_cannot) {
  four_bars whole;
  kanexpr::state<System, float> x(whole.x.cast<float>());
  kanexpr::parameter_values<System, float> p(whole.p.cast<float>());
  p[four_bar::l0] = 9; // longer than the other bars together
  const auto made = kanexpr::assemble<System>(x, p);
  EXPECT_FALSE(made);
  EXPECT_NE(made.cause().find("dependent coordinates"), std::string_view::npos) << made.cause();
  kanexpr::parameter_values<System, float> unset;
  EXPECT_EQ(kanexpr::assemble<System>(x, unset).cause(), "parameter m1 has no value");
}

} // namespace
