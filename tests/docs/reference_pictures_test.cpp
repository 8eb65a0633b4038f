// builds: g++
// Examples of single names of figures and pictures: docs/reference/examples.md.
#include <kanexpr/animate.hpp>
#include <kanexpr/figures.hpp>
#include <models/simple_pendulum.hpp>

#include <gtest/gtest.h>

namespace {

using namespace simple_pendulum;

#include <docs/reference/examples/picture.cpp>

static_assert(!shapes::mistake);

TEST(reference, has_figures) {
#include <docs/reference/examples/figure.cpp>
  EXPECT_TRUE(drawing) << drawing.cause();
}

} // namespace
