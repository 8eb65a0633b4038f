// docs/how-it-works.md
#include <gtest/gtest.h>

namespace {

#include <docs/how-it-works/interpreter_fault.cpp>

TEST(how_it_works, shows_what_compilers_accept) { EXPECT_EQ(f<derived<3>{}>(), 3); }

} // namespace
