// builds: clang++
// Compares the extremes of runs with those of known functions of time.
#include "ensembles/turning.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

namespace {

using namespace simple_pendulum;

TEST(extremes, are_found_where_many_lie_in_one_step) {
  study<System> told = turning({{q, {0, 1}}, {u, evenly_spaced(0.3, 6, 60)}});
  told.keep = {greatest<q * sin(q)>("top"), least<dot(position_of<P, O>, N::x)>("lowest")};

  const auto found = ensemble<System>(told).run();
  ASSERT_TRUE(found) << found.cause();
  for (std::size_t i = 0; i < found.runs.rows(); ++i) {
    const double from = found.runs["q"][i], to = from + 20 * found.runs["u"][i];
    double top = -1e9, lowest = 1;
    for (int k = 0; k <= 300'000; ++k) {
      const double at = from + (to - from) * k / 3e5;
      top = std::max(top, at * std::sin(at)), lowest = std::min(lowest, std::cos(at));
    }
    EXPECT_NEAR(found.runs["top"][i], top, 1e-5) << from << ' ' << to;
    EXPECT_NEAR(found.runs["lowest"][i], lowest, 1e-7) << from << ' ' << to;
  }
}

TEST(extremes, are_found_where_an_event_makes_a_jump) {
  study<System> told = turning({{u, {0.1}}, {factor{"after"}, {0.9, 1, 1.09, 1.0999}}});
  told.state = {{q, 0}};
  told.for_each_run = [](const run_values& run, simulation_setup<System>& one) {
    one.options.events = {
        when<System, q - 1.1>("there", crossing::rising,
                              [to = run["after"]](moment<System>& now) { now.x[q] = to, now.x[u] = -0.1; })};
  };
  told.keep = {greatest<q>(), least<u>()};
  const auto found = ensemble<System>(told).run();
  ASSERT_TRUE(found) << found.cause();
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(found.runs["q_greatest"][i], 1.1, 1e-9);
    EXPECT_NEAR(found.runs["u_least"][i], -0.1, 1e-12);
  }
}

TEST(extremes, may_be_beside_infinities) {
  study<System> told = turning({{u, {0, 0.1, 0.5}}});
  told.state = {{q, 0}};
  told.keep = {greatest<log(q)>("log"), least<log(q)>("no bound")};
  const auto found = ensemble<System>(told).run();
  ASSERT_TRUE(found) << found.cause();
  EXPECT_NEAR(found.runs["log"][1], std::log(2), 1e-8);
  EXPECT_NEAR(found.runs["log"][2], std::log(10), 1e-8);
  EXPECT_EQ(found.runs["log"][0], -INFINITY);
  EXPECT_EQ(found.runs["no bound"][2], -INFINITY);
}

TEST(extremes, of_inputs_are_those_of_their_function) {
  study<System> told = turning({{u, {0.1}}});
  told.state = {{q, 0}};
  told.inputs = {};
  told.simulation.inputs = [](double t) { return input_values<System>{{T, 1e-3 * std::sin(0.9 * t)}}; };
  told.keep = {greatest<T>(), least<T>()};
  const auto found = ensemble<System>(told).run();
  ASSERT_TRUE(found) << found.cause();
  EXPECT_NEAR(found.runs["T_greatest"][0], 1e-3, 1e-10);
  EXPECT_NEAR(found.runs["T_least"][0], -1e-3, 1e-10);
}

TEST(extremes, leave_the_samples_as_they_are_asked_for) {
  study<System> told = turning({{u, {0.1}}});
  told.state = {{q, 0}};
  told.simulation.output_every = 1;
  std::vector<double> shown;
  told.simulation.each_sample = [&](const sample<System>& s) { shown.push_back(s.t); };
  told.keep = {
      result("samples", [](const simulation<System>& run) { return double(run.trajectory.size()); })};
  const auto plain = ensemble<System>(told).run({.threads = 1});
  const std::vector<double> expected = shown;
  shown.clear();
  told.keep.push_back(greatest<q>());
  const auto watched = ensemble<System>(told).run({.threads = 1});
  ASSERT_TRUE(plain && watched);
  EXPECT_EQ(plain.runs["samples"][0], 21);
  EXPECT_EQ(watched.runs["samples"][0], 21);
  EXPECT_EQ(shown, expected);
}

} // namespace
