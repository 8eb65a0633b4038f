// builds: clang++ all
// A program may use names of this library together with those of SUNDIALS.
#include <kanexpr/kanexpr.hpp>

using namespace kanexpr; // before SUNDIALS' own headers are read

#include <kanexpr/operating_point.hpp>
#include <kanexpr/simulate.hpp>

#include <sundials/sundials_context.hpp>
#include <sundials/sundials_nvector.hpp>

#include <gtest/gtest.h>

namespace {

TEST(with_sundials, names_do_not_collide) {
  const sundials::Context context;
  EXPECT_NE(context.Convert(), nullptr);
  using namespace sundials;
  const Context other;
  EXPECT_NE(other.Convert(), nullptr);
}

} // namespace
