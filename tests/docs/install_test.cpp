// docs/install.md
#include <gtest/gtest.h>

namespace {

#include <docs/install/interpreter_fault.cpp>

TEST(install, shows_what_compilers_accept) { EXPECT_EQ(f<derived<3>{}>(), 3); }

} // namespace
