// builds: clang++ sanitize
// The published formulas, compared with the published numbers.
#include "oracles.hpp"
#include "systems/andrews_reference.hpp"

#include <random>

namespace {

using namespace andrews_reference;

TEST(andrews_reference, starts_as_published) {
  EXPECT_LE(gap(start).norm(), 1e-16);
  const solution at_start = solve(start, vector7::Zero());
  EXPECT_TRUE(oracle::close(at_start.acceleration, start_acceleration, 1e-12));
  EXPECT_TRUE(oracle::close(at_start.multipliers, start_multipliers, 1e-12));
}

TEST(andrews_reference, jacobian_is_the_derivative_of_the_loops) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> angle(-3, 3);
  for (int repeat = 0; repeat < 10; ++repeat) {
    const vector7 q = vector7::NullaryExpr([&] { return angle(random); });
    for (int i = 0; i < 7; ++i) {
      std::array<hand_written::jet, 7> along;
      for (int j = 0; j < 7; ++j) along[static_cast<std::size_t>(j)] = {q(j), i == j ? 1.0 : 0.0, 0};
      for (int j = 0; j < 6; ++j)
        EXPECT_NEAR(jacobian(q)(j, i), loops(along)[static_cast<std::size_t>(j)].rate, 1e-16);
    }
  }
}

} // namespace
