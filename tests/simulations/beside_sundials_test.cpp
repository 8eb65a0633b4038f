// A program may use the names of this library and those of SUNDIALS side by side.
#include <kanexpr/kanexpr.hpp>

using namespace kanexpr; // before SUNDIALS' own headers are read

#include <kanexpr/operating_point.hpp>
#include <kanexpr/simulate.hpp>

#include <sundials/sundials_context.hpp>
#include <sundials/sundials_nvector.hpp>

#include <gtest/gtest.h>

namespace {

TEST(beside_sundials, its_names_are_its_own) {
  const sundials::Context context;
  EXPECT_NE(context.Convert(), nullptr);
  using namespace sundials;
  const Context other;
  EXPECT_NE(other.Convert(), nullptr);
}

} // namespace
