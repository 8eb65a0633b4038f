// builds: clang++ all
// Examples of single names of studies: docs/reference/examples.md.
#include <kanexpr/ensemble.hpp>
#include <kanexpr/hdf5.hpp>
#include <models/simple_pendulum.hpp>

#include <gtest/gtest.h>

#include <iostream>

namespace {

using namespace simple_pendulum;

#include <docs/reference/examples/generic.cpp>
#include <docs/reference/examples/results_file.cpp>

TEST(reference, has_studies) {
#include <docs/reference/examples/distributions.cpp>
#include <docs/reference/examples/outputs.cpp>
  EXPECT_EQ(kept.size(), 3u);
  EXPECT_EQ(last.what.name, "q_end");
  {
#include <docs/reference/examples/options.cpp>
    EXPECT_EQ(how.reduce.size(), 3u);
  }
  ensemble_options how{.reduce = {statistics_of("q_end"), quantiles_of("q_end"), counts_of("flips"),
                                  histogram_of("q_end", -3, 3, 12)},
                       .files = {std::make_shared<failures_only>()}};
  const ensemble_results found = ensemble<System>({.runs = grid({{q, {0.1, 0.2}}}),
                                                   .state = {{u, 0}},
                                                   .parameters = {{m, 1}, {l, 1}, {g, 9.81}, {c, 0.1}},
                                                   .inputs = {{T, 0}},
                                                   .span = {0, 0.1},
                                                   .simulation = {.events = {when<System, q>("flip")}},
                                                   .keep = {at_end<q>(), times_of("flip", "flips")}})
                                     .run(how);
  ASSERT_TRUE(found) << found.cause();
#include <docs/reference/examples/setup.cpp>
#include <docs/reference/examples/summary.cpp>
  EXPECT_EQ(speed.count() + ranks.count() + flips.count(0) + bins.below(), 6u);
#include <docs/reference/examples/hdf5.cpp>
  EXPECT_NE(file, nullptr);
}

} // namespace
