// builds: clang++
// Smooth functions, compared with numbers of 60 digits.
#include "references.hpp"
#include "symbolic/symbols.hpp"

#include <kanexpr/symbolic/derivatives/differentiate.hpp>
#include <kanexpr/symbolic/graph/composed.hpp>
#include <kanexpr/symbolic/graph/evaluate.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace {

using namespace kanexpr::symbolic;

class smooth : public testing::Test, protected symbols {
protected:
  double at(expression e, double x_is, double y_is, double z_is = 0) const {
    return values_at(g, {e.node()}, [&](int id) {
      return id == x.node() ? x_is : id == y.node() ? y_is : z_is;
    })[0];
  }
  /// The tolerances of the value, its slope and its curvature are in addition to those of the reference.
  template <std::size_t count>
  void expect_rows(const references::row (&rows)[count], expression e, double tolerance) const {
    const expression slope = differentiate(e, x), curvature = differentiate(slope, x);
    for (const references::row& given : rows) {
      SCOPED_TRACE(testing::Message() << given.x << ", " << given.first << ", " << given.second);
      const double size = std::abs(given.first - given.second);
      EXPECT_NEAR(at(e, given.x, given.first, given.second), given.value,
                  tolerance * (std::abs(given.value) + std::fmin(size, 1)));
      EXPECT_NEAR(at(slope, given.x, given.first, given.second), given.slope, 20 * tolerance);
      EXPECT_NEAR(at(curvature, given.x, given.first, given.second), given.curvature, 100 * tolerance / size);
    }
  }
};

TEST_F(smooth, functions_have_the_values_and_slopes_of_their_formulas) {
  expect_rows(references::smooth_abs, smooth_abs(x, y), 4e-16);
  expect_rows(references::softplus, softplus(x, y), 4e-16);
  expect_rows(references::smooth_step, smooth_step(x, y, z), 4e-16);
}

TEST_F(smooth, functions_do_not_overflow) {
  constexpr double huge = 1.7e308;
  for (const double width : {1e-3, 1.0, 6e-309, std::numeric_limits<double>::denorm_min()}) {
    EXPECT_EQ(at(smooth_abs(x, y), -huge, width), huge);
    EXPECT_EQ(at(softplus(x, y), huge, width), huge);
    EXPECT_EQ(at(softplus(x, y), -huge, width), 0);
    EXPECT_EQ(at(smooth_abs(x, y), 0, width), 0);
    EXPECT_EQ(at(softplus(x, y), 0, width), width * std::log(2.0));
    if (width < 6e-309) continue; // 1/width is infinite
    EXPECT_EQ(at(differentiate(smooth_abs(x, y), x), -huge, width), -1);
    EXPECT_EQ(at(differentiate(softplus(x, y), x), huge, width), 1);
    EXPECT_EQ(at(differentiate(softplus(x, y), x), -huge, width), 0);
    EXPECT_EQ(at(differentiate(softplus(x, y), x), 0, width), 0.5);
    EXPECT_EQ(at(differentiate(smooth_abs(x, y), x), 0, width), 0);
  }
  EXPECT_EQ(at(smooth_step(x, y, z), huge, -1, 1), 1);
  EXPECT_EQ(at(smooth_step(x, y, z), -huge, -1, 1), 0);
}

TEST_F(smooth, step_joins_its_ends_with_two_derivatives) {
  const expression step = smooth_step(x, y, z), slope = differentiate(step, x),
                   curvature = differentiate(slope, x);
  for (const double end : {1.0, 3.0}) {
    EXPECT_EQ(at(step, end, 1, 3), end == 1.0 ? 0 : 1);
    for (const double beside : {end - 1e-9, end, end + 1e-9}) {
      EXPECT_NEAR(at(slope, beside, 1, 3), 0, 1e-17 + 15e-18);
      EXPECT_NEAR(at(curvature, beside, 1, 3), 0, 2e-8);
    }
  }
  EXPECT_EQ(at(step, 2, 1, 3), 0.5);
}

} // namespace
