// Models that are compiled once: docs/guide/compiled-once.md. tests/consumer/linked has the rest.
#include <kanexpr/kanexpr.hpp>

#include "consumer/pendulum.hpp"

#include <gtest/gtest.h>

#include <iostream>

using namespace kanexpr;

#include <docs/guide/compiled-once/header.cpp>
#include <docs/guide/compiled-once/source.cpp>

namespace {

TEST(compiled_once, is_called_as_ever) {
#include <docs/guide/compiled-once/use.cpp>
  EXPECT_EQ(A.rows(), 2);
  const auto found = rates(0.0, x, p, eom::inputs());
  EXPECT_EQ(found(1), udot(0));
  EXPECT_TRUE(found.status);
}

} // namespace
