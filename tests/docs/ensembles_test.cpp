// builds: g++
// Many simulations: docs/guide/ensembles.md.
#include <docs/guide/ensembles/files_header.cpp>
#include <kanexpr/ensemble.hpp>
#include <models/simple_pendulum.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <iostream>

namespace {

TEST(ensembles, are_studied) {
  const auto keep = std::cout.rdbuf(nullptr); // a thousand times
#include <docs/guide/ensembles/study.cpp>
  std::cout.rdbuf(keep);
  ASSERT_TRUE(found) << found.cause();
  EXPECT_EQ(found.failed, 0u);
  const auto one = simulate<System>({{q, found.runs["q"][7]}, {u, 0}},
                                    {{m, 1}, {l, found.runs["l"][7]}, {g, 9.81}, {c, 0.1}}, {0, 10},
                                    {.inputs = {{T, 0}}, .events = {when<System, q>("passes")}});
  EXPECT_EQ(found.runs["t_passes"][7], one.events.front().t);
#include <docs/guide/ensembles/factors.cpp>
  ASSERT_TRUE(held) << held.cause();
  EXPECT_NEAR(held.runs["torque"][0], -5 * std::acos(0.9), 1e-12);
#include <docs/guide/ensembles/reductions.cpp>
  EXPECT_EQ(summary.runs.rows(), 0u);
  EXPECT_EQ(summary.statistics("fastest").count(), 1000u);
  EXPECT_EQ(summary.histogram("q").count(0), 50u);
#include <docs/guide/ensembles/checkpoint.cpp>
#include <docs/guide/ensembles/failures.cpp>
  EXPECT_TRUE(kept) << kept.cause();
  EXPECT_FALSE(std::filesystem::exists("study.checkpoint"));
#include <docs/guide/ensembles/files.cpp>
  EXPECT_TRUE(written) << written.cause();
  EXPECT_EQ(read_csv("study.csv").rows(), 1000u);
#include <docs/guide/ensembles/in_steps.cpp>
  ASSERT_TRUE(swung) << swung.cause();
  EXPECT_EQ(swung.runs["q_greatest"][999], 3);
}

} // namespace
