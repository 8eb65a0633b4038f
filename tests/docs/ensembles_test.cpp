// builds: g++
// Many simulations: docs/guide/ensembles.md.
#include "simulate/falling_ball.hpp"

#include <docs/guide/ensembles/files_header.cpp>
#include <kanexpr/ensemble.hpp>

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
  for (std::size_t i = 0; i < 1000; ++i)
    EXPECT_NEAR(found.runs["t_contact"][i], std::sqrt(2 * found.runs["h"][i] / 9.81), 1e-7);
#include <docs/guide/ensembles/factors.cpp>
  ASSERT_TRUE(bounces) << bounces.cause();
  EXPECT_EQ(bounces.runs["restitution"][2], 0.7);
  EXPECT_GT(bounces.runs["contacts"][4], 0);
#include <docs/guide/ensembles/reductions.cpp>
  EXPECT_EQ(summary.runs.rows(), 0u);
  EXPECT_EQ(summary.statistics("v_end").count(), 1000u);
  EXPECT_EQ(summary.histogram("h").count(0), 50u);
#include <docs/guide/ensembles/checkpoint.cpp>
#include <docs/guide/ensembles/failures.cpp>
  EXPECT_TRUE(kept) << kept.cause();
  EXPECT_FALSE(std::filesystem::exists("balls.checkpoint"));
#include <docs/guide/ensembles/files.cpp>
  EXPECT_TRUE(written) << written.cause();
  EXPECT_EQ(read_csv("study.csv").rows(), 1000u);
#include <docs/guide/ensembles/in_steps.cpp>
  ASSERT_TRUE(fallen) << fallen.cause();
  EXPECT_NEAR(fallen.runs["v_end"][7], -9.81 * 0.5, 1e-12);
}

} // namespace
