// builds: clang++ all
// Examples of single names of pictures: docs/reference/examples.md.
#include <kanexpr/animate.hpp>
#include <models/simple_pendulum.hpp>

#include <gtest/gtest.h>

namespace {

using namespace simple_pendulum;

#include <docs/reference/examples/picture.cpp>

static_assert(!shapes::mistake && !bent_shapes::mistake);

TEST(reference, has_pictures) { EXPECT_EQ(page.title, "A pendulum"); }

} // namespace
