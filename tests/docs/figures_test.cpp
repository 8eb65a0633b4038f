// Figures: docs/figures.md. The figure of the page is the one that its code draws.
#include <docs/figures/crane.cpp>

#include <gtest/gtest.h>

#include <fstream>
#include <iostream>
#include <sstream>

namespace {

using namespace kanexpr;

TEST(figures, are_those_of_the_page) {
#include <docs/figures/drawn.cpp>
  ASSERT_TRUE(f) << f.cause();
  std::ostringstream page;
  page << std::ifstream(KANEXPR_DOCS "/figures/crane.svg").rdbuf();
  EXPECT_EQ(f.svg(), page.str()) << "copy crane.svg from the folder of this test to docs/figures";
}

} // namespace
