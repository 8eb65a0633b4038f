// builds: g++
// Examples of single names of batches, figures and pictures: docs/reference/examples.md.
#include <kanexpr/animate.hpp>
#include <kanexpr/batch.hpp>
#include <kanexpr/figures.hpp>
#include <models/simple_pendulum.hpp>

#include <gtest/gtest.h>

namespace {

using namespace simple_pendulum;
using eom = equations_of_motion<System>;

#include <docs/reference/examples/picture.cpp>

static_assert(!shapes::mistake);

TEST(reference, has_batches_and_figures) {
  {
#include <docs/reference/examples/batches.cpp>
    EXPECT_EQ(rates.size(), 1000);
  }
#include <docs/reference/examples/figure.cpp>
  EXPECT_TRUE(drawing) << drawing.cause();
}

} // namespace
