// builds: clang++ all
// docs/coming-from: kanexpr's programs that simulate, and that read a robot from a file, print what the pages
// show.
#include "docs/printed.hpp"
#include "docs/text.hpp"

#include <gtest/gtest.h>

#define main print_pydy
#include <docs/coming-from/pydy/ours.cpp>
#undef main
#define main print_pinocchio
#include <docs/coming-from/pinocchio/ours.cpp>
#undef main

namespace {

TEST(coming_from, simulates) {
  const docs::printed here;
  EXPECT_EQ(print_pydy(), 0);
  EXPECT_EQ(here.text(), docs::text("docs/coming-from/pydy/printed.text"));
}

TEST(coming_from, reads_a_robot) {
  const docs::printed here;
  EXPECT_EQ(print_pinocchio(), 0);
  EXPECT_EQ(here.text(), docs::text("docs/coming-from/pinocchio/printed.text"));
}

} // namespace
