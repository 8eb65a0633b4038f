// builds: g++
// The program in docs/guide/ensembles.md that mpirun starts, run here with a single rank.
#include <models/simple_pendulum.hpp>

#define main study_on_ranks // a program has only one main
#include <docs/guide/ensembles/ranks.cpp>
#undef main

#include <gtest/gtest.h>

namespace {

TEST(ensembles, are_studied_on_ranks) {
  testing::internal::CaptureStdout();
  char name[] = "study";
  char* words[] = {name, nullptr};
  EXPECT_EQ(study_on_ranks(1, words), 0);
  EXPECT_GT(std::stod(testing::internal::GetCapturedStdout()), 1);
}

} // namespace
