// builds: clang++
// docs/coming-from: kanexpr's programs print what the pages show.
#include "docs/printed.hpp"
#include "docs/text.hpp"

#include <gtest/gtest.h>

#define main print_autolev
#include <docs/coming-from/autolev/ours.cpp>
#undef main
#define main print_casadi
#include <docs/coming-from/casadi/ours.cpp>
#undef main
#define main print_drake
#include <docs/coming-from/drake/ours.cpp>
#undef main
#define main print_motiongenesis
#include <docs/coming-from/motiongenesis/ours.cpp>
#undef main
#define main print_mujoco
#include <docs/coming-from/mujoco/ours.cpp>
#undef main
#define main print_sympy
#include <docs/coming-from/sympy/ours.cpp>
#undef main

namespace {

void expect_printed(const std::string& page, int (*program)()) {
  const docs::printed here;
  EXPECT_EQ(program(), 0);
  EXPECT_EQ(here.text(), docs::text("docs/coming-from/" + page + "/printed.text"));
}

TEST(coming_from, prints_accelerations) {
  expect_printed("autolev", print_autolev);
  expect_printed("casadi", print_casadi);
  expect_printed("drake", print_drake);
  expect_printed("motiongenesis", print_motiongenesis);
  expect_printed("mujoco", print_mujoco);
  expect_printed("sympy", print_sympy);
}

} // namespace
