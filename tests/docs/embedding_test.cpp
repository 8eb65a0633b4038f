// docs/embedding.md, except for the program, which `on_board` runs.
#include "models/simple_pendulum.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <type_traits>

namespace {

using namespace simple_pendulum;
using eom = kanexpr::equations_of_motion<System>;

TEST(embedding, is_in_single_precision) {
#include <docs/embedding/vectors.cpp>
  static_assert(std::is_same_v<std::decay_t<decltype(udot[0])>, float>);
  const float expected = -9.81F / 0.5F * std::sin(0.3F);
  EXPECT_NEAR(udot[0], expected, 1e-6F);

  const float buffer[]{0.3F, 0};
#include <docs/embedding/mapped.cpp>
  static_assert(std::is_same_v<std::decay_t<decltype(rate[0])>, float>);
  EXPECT_EQ(rate[0], 0);
  EXPECT_EQ(rate[1], udot[0]);
}

} // namespace
