// builds: clang++ all
// Units: docs/guide/units.md.
#include "docs/no_mistake.hpp"
#include "docs/printed.hpp"
#include "docs/text.hpp"

#include <kanexpr/kanexpr.hpp>
#include <kanexpr/runtime/builder.hpp>

#include <iostream>

namespace {

namespace pendulum {

#include <docs/guide/units/model.cpp>
#include <docs/guide/units/numbered.cpp>
#include <docs/guide/units/results.cpp>

TEST(units, of_a_pendulum_are_inferred) {
  docs::expect_no_mistake<System>();
  const docs::printed printed;
#include <docs/guide/units/print.cpp>
  EXPECT_EQ(printed.text(), docs::text("docs/guide/units/printed.text"));
}

TEST(units, are_stated_in_a_builder) {
#include <docs/guide/units/builder.cpp>
  EXPECT_EQ(b.unit_of(m), kilogram);
  EXPECT_EQ(b.unit_of(m * q), kilogram * radian);
}

} // namespace pendulum

} // namespace
