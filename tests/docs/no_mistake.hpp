#pragma once

#include <kanexpr/symbolic.hpp>

#include <gtest/gtest.h>

namespace docs {

/// A system that the documentation shows is sound.
template <class System>
void expect_no_mistake() {
  EXPECT_EQ(kanexpr::derive<System>().mistake(), "");
}

} // namespace docs
