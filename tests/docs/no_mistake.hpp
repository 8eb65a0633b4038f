#pragma once

#include <kanexpr/symbolic.hpp>

#include <gtest/gtest.h>

namespace docs {

/// Checks that a system in the documentation has no mistakes.
template <class System>
void expect_no_mistake() {
  EXPECT_EQ(kanexpr::derive<System>().mistake(), "");
}

} // namespace docs
