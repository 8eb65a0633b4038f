// builds: clang++ sanitize
#include "simulations/falling_ball.hpp"

#include <kanexpr/ensemble.hpp>

#include <gmock/gmock.h>

#include <bit>
#include <cmath>
#include <stdexcept>

namespace {

using namespace kanexpr;
using namespace falling_ball;

constexpr double restitution = 0.8;
void bounce(moment<System>& now) { now.x[v] = -restitution * now.x[v]; }
constexpr auto height = dot(position_of<P, O>, N::z);

study<System> bouncing_balls() {
  return {
      .runs = latin_hypercube(40, {{h, uniform(1, 3)}, {g, truncated_normal(9.8, 1, 5, 15)}}, 9),
      .state = {{v, 0}},
      .parameters = {{m, 0.3}},
      .span = {0, 2},
      .simulation = {.relative_tolerance = 1e-10,
                     .absolute_tolerance = 1e-12,
                     .events = {when<System, height>("contact", crossing::falling, bounce)}},
      .keep = {at_end<v>("speed", "m/s"), at_end<height>("height", "m"), greatest<v>("fastest up", "m/s"),
               least<v>("fastest down"), first_time_of("contact", "t_contact"),
               last_time_of("contact", "t_last"), times_of("contact", "contacts"),
               result("steps", [](const simulation<System>& run) { return double(run.statistics.steps); }),
               result("fallen", [](const run_values& given,
                                   const simulation<System>& run) { return given[h] - run.state[h]; })},
      .keep_end_state = true,
      .keep_events = true,
      .units = {{h, "m"}, {v, "m/s"}, {g, "m/s2"}, {m, "kg"}}};
}

// Compares all bits, also those of NaN.
void expect_equal(const table& a, const table& b) {
  ASSERT_EQ(a.names(), b.names());
  ASSERT_EQ(a.rows(), b.rows());
  for (std::size_t i = 0; i < a.columns(); ++i)
    for (std::size_t k = 0; k < a.rows(); ++k)
      EXPECT_EQ(std::bit_cast<std::uint64_t>(a.values(i)[k]), std::bit_cast<std::uint64_t>(b.values(i)[k]))
          << a.names()[i] << ' ' << k;
}

TEST(ensemble, keeps_what_single_simulations_find) {
  const study<System> told = bouncing_balls();
  const auto found = ensemble<System>(told).run();
  ASSERT_TRUE(found) << found.cause();
  ASSERT_EQ(found.runs.rows(), 40u);
  EXPECT_EQ(found.failed, 0u);
  for (std::size_t i = 0; i < 40; ++i) {
    const double from = found.runs["h"][i], strength = found.runs["g"][i];
    const auto alone =
        simulate<System>({{h, from}, {v, 0}}, {{m, 0.3}, {g, strength}}, {0, 2}, told.simulation);
    ASSERT_TRUE(alone) << alone.cause();
    EXPECT_EQ(found.runs["run"][i], double(i));
    EXPECT_EQ(found.runs["end"][i], 0);
    EXPECT_EQ(found.runs["t_end"][i], 2);
    EXPECT_EQ(found.runs["v_end"][i], alone.state[v]);
    EXPECT_EQ(found.runs["height"][i], alone.state[h]);
    EXPECT_EQ(found.runs["h_end"][i], alone.state[h]);
    EXPECT_EQ(found.runs["steps"][i], double(alone.statistics.steps));
    EXPECT_EQ(found.runs["fallen"][i], from - alone.state[h]);
    EXPECT_EQ(found.runs["contacts"][i], double(alone.events.size()));
    EXPECT_EQ(found.events[i].size(), alone.events.size());
    ASSERT_FALSE(alone.events.empty());
    EXPECT_EQ(found.events[i].back().t, alone.events.back().t);
    EXPECT_EQ(found.events[i].back().name, "contact");
    EXPECT_EQ(found.runs["t_last"][i], alone.events.back().t);
    // The closed-form solution.
    const double impact = std::sqrt(2 * strength * from);
    EXPECT_NEAR(found.runs["t_contact"][i], std::sqrt(2 * from / strength), 1e-9);
    EXPECT_NEAR(found.runs["fastest up"][i], restitution * impact, 1e-8);
    EXPECT_NEAR(found.runs["fastest down"][i], -impact, 1e-8);
  }
}

TEST(ensemble, does_not_depend_on_threads) {
  study<System> told = bouncing_balls();
  told.keep_trajectories = true;
  const ensemble<System> balls(told);
  std::vector<reduction> reductions{statistics_of("v_end"), quantiles_of("t_contact"),
                                    histogram_of("h_end", 0, 2, 8), counts_of("contacts")};
  const auto alone = balls.run({.threads = 1, .reduce = reductions});
  const auto shared = balls.run({.threads = 7, .reduce = reductions});
  ASSERT_TRUE(alone && shared);
  expect_equal(alone.runs, shared.runs);
  EXPECT_EQ(alone.statistics("v_end").variance(), shared.statistics("v_end").variance());
  EXPECT_EQ(alone.quantiles("t_contact").quantile(0.5), shared.quantiles("t_contact").quantile(0.5));
  EXPECT_EQ(alone.histogram("h_end").count(3), shared.histogram("h_end").count(3));
  EXPECT_EQ(alone.counts("contacts").counts(), shared.counts("contacts").counts());
  EXPECT_EQ(alone.statistics("h_end").count(), 0u); // not requested
  ASSERT_EQ(alone.trajectories.size(), 40u);
  for (std::size_t i = 0; i < 40; ++i) expect_equal(alone.trajectories[i], shared.trajectories[i]);
}

TEST(ensemble, keeps_trajectories_at_the_times_that_are_asked_for) {
  study<System> told{.runs = grid({{h, {2, 3}}}),
                     .state = {{v, 1}},
                     .parameters = {{m, 0.3}, {g, 9.81}},
                     .span = {0, 0.5},
                     .simulation = {.relative_tolerance = 1e-12, .output_every = 0.125},
                     .keep_trajectories = true};
  const auto sampled = ensemble<System>(told).run();
  told.keep = {greatest<h>("top")};
  const auto watched = ensemble<System>(told).run();
  ASSERT_TRUE(sampled && watched);
  EXPECT_THAT(sampled.trajectories[1]["t"], testing::ElementsAre(0, 0.125, 0.25, 0.375, 0.5));
  for (std::size_t i = 0; i < 2; ++i) {
    ASSERT_EQ(watched.trajectories[i].names(), sampled.trajectories[i].names());
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t k = 0; k < 5; ++k)
        EXPECT_NEAR(watched.trajectories[i].values(c)[k], sampled.trajectories[i].values(c)[k], 1e-12);
    EXPECT_NEAR(watched.runs["top"][i], watched.runs["h"][i] + 0.5 / 9.81, 1e-11); // between samples
  }
}

TEST(ensemble, goes_on_where_a_run_fails) {
  study<System> told = bouncing_balls();
  told.runs = grid({{h, {2, 2, 2}}, {factor{"restitution"}, {0.8, 0}}, {g, {9.81, INFINITY}}});
  told.for_each_run = [](const run_values& run, simulation_setup<System>& one) {
    one.options.events = {
        when<System, height>("contact", crossing::falling, [e = run["restitution"]](moment<System>& now) {
          now.x[h] = 0;
          now.x[v] = -e * now.x[v];
        })};
  };
  const auto found = ensemble<System>(told).run({.reduce = {statistics_of("v_end")}});
  ASSERT_TRUE(found) << found.cause();
  EXPECT_EQ(found.done, 12u);
  EXPECT_EQ(found.failed, 9u);
  ASSERT_EQ(found.failures.size(), 9u);
  EXPECT_EQ(found.failures[0].run, 1u);
  EXPECT_EQ(found.failures[0].cause, "the value of parameter g is infinite");
  EXPECT_EQ(found.failures[1].run, 2u);
  EXPECT_THAT(found.failures[1].cause,
              testing::AllOf(testing::StartsWith("the simulation ended at t = 0.638550862 with h = "),
                             testing::EndsWith("events occur faster and faster; a handler must stop this")));
  EXPECT_NEAR(found.failures[1].time, std::sqrt(4 / 9.81), 1e-6);
  ASSERT_EQ(found.failures[1].state.size(), 2u);
  EXPECT_NEAR(found.failures[1].state[0], 0, 1e-9);
  EXPECT_EQ(found.runs["end"][2], 2);
  EXPECT_EQ(found.runs["restitution"][2], 0);
  EXPECT_TRUE(std::isnan(found.runs["v_end"][2]) && std::isnan(found.runs["contacts"][2]));
  EXPECT_FALSE(std::isnan(found.runs["v_end"][0]));
  EXPECT_EQ(found.statistics("v_end").count(), 3u);
  EXPECT_EQ(found.statistics("v_end").missing(), 0u);
}

TEST(ensemble, tells_what_was_thrown_and_what_is_no_number) {
  study<System> told{
      .runs = grid({{h, {1, 2, 3, 4}}}),
      .state = {{v, 0}},
      .parameters = {{m, 0.3}, {g, 9.81}},
      .span = {0, 0.1},
      .for_each_run =
          [](const run_values& run, simulation_setup<System>&) {
            if (run[h] > 3.5) throw 4;
            if (run[h] > 2.5) throw std::invalid_argument("a push of no size");
          },
      .keep = {result("root", [](const simulation<System>& run) { return std::sqrt(run.state[h] - 1.5); })}};
  const auto found = ensemble<System>(told).run();
  ASSERT_EQ(found.failures.size(), 3u);
  EXPECT_EQ(found.failures[0].cause, "root is not a number");
  EXPECT_EQ(found.failures[0].state.size(), 2u);
  EXPECT_EQ(found.failures[1].cause, "a push of no size");
  EXPECT_EQ(found.failures[2].cause, "something other than a std::exception was thrown");
  EXPECT_EQ(found.runs["end"][1], 0);
}

TEST(ensemble, lets_a_function_set_what_goes_together) {
  study<System> told{.runs = grid({{factor{"energy"}, {1, 2, 3}}}),
                     .state = {{v, 0}},
                     .parameters = {{m, 0.5}},
                     .span = {0, 0.1},
                     .for_each_run =
                         [](const run_values& run, simulation_setup<System>& one) {
                           one.p[g] = 10;
                           if (run["energy"] < 2.5) one.x[h] = run["energy"] / (one.p[m] * one.p[g]);
                         },
                     .keep = {at_end<m * g * h>("potential energy"), greatest<h>()}};
  const auto found = ensemble<System>(told).run();
  EXPECT_EQ(found.failed, 1u);
  EXPECT_EQ(found.failures[0].cause, "the value of coordinate h is not a number"); // unset
  for (std::size_t i : {0u, 1u}) {
    EXPECT_NEAR(found.runs["h_greatest"][i], found.runs["energy"][i] / 5, 1e-12);
    EXPECT_NEAR(found.runs["potential energy"][i], found.runs["energy"][i] - 0.5 * 0.5, 1e-7);
  }
}

TEST(ensemble, of_which_all_runs_fail_is_none) {
  study<System> told = bouncing_balls();
  told.for_each_run = [](const run_values&, simulation_setup<System>&) { throw std::logic_error("no ball"); };
  const auto found = ensemble<System>(told).run();
  EXPECT_FALSE(found);
  EXPECT_EQ(found.cause(), "all 40 runs failed, the first of them: no ball");
}

TEST(ensemble, drops_no_event_in_silence) {
  study<System> told = bouncing_balls();
  told.for_each_run = [](const run_values& run, simulation_setup<System>& one) {
    if (run.run() == 7) one.options.events.push_back(when<System, v>("top", crossing::falling));
  };
  const auto found = ensemble<System>(told).run();
  ASSERT_EQ(found.failures.size(), 1u);
  EXPECT_EQ(found.failures[0].run, 7u);
  EXPECT_EQ(found.failures[0].cause, "the event top is not an event of the study");
}

TEST(ensemble, ends_as_an_event_asks) {
  study<System> told = bouncing_balls();
  told.simulation.events = {when<System, height>("contact", crossing::falling, after_event::stop)};
  const auto found = ensemble<System>(told).run();
  ASSERT_TRUE(found) << found.cause();
  for (std::size_t i = 0; i < 40; ++i) {
    EXPECT_EQ(found.runs["end"][i], 1);
    EXPECT_EQ(found.runs["t_end"][i], found.runs["t_contact"][i]);
    EXPECT_NEAR(found.runs["h_end"][i], 0, 1e-9);
  }
}

TEST(ensemble, names_columns_with_units) {
  const study_layout layout = ensemble<System>(bouncing_balls()).layout();
  const auto& columns = layout.columns;
  std::vector<column_label> first(columns.begin(), columns.begin() + 6);
  EXPECT_THAT(first, testing::ElementsAre(column_label{"run"}, column_label{"end"},
                                          column_label{"t_end", "s"}, column_label{"h", "m"},
                                          column_label{"g", "m/s2"}, column_label{"speed", "m/s"}));
  EXPECT_EQ(columns[8], (column_label{"fastest down", "m/s"})); // the unit of its symbol
  EXPECT_EQ(columns[13], (column_label{"fallen"}));
  EXPECT_EQ(columns[15], (column_label{"v_end", "m/s"}));
  EXPECT_THAT(layout.constants,
              testing::ElementsAre(constant_of_runs{{"v", "m/s"}, 0}, constant_of_runs{{"m", "kg"}, 0.3}));
}

std::string refusal(study<System> told, const ensemble_options& options = {}) {
  const auto found = ensemble<System>(std::move(told)).run(options);
  EXPECT_FALSE(found);
  EXPECT_EQ(found.done, 0u);
  return found.cause();
}

TEST(ensemble, says_what_was_told_wrongly) {
  study<System> told = bouncing_balls();
  told.runs = grid({{"m_2", {1}}});
  EXPECT_EQ(refusal(told),
            "the system System has no m_2 to vary; for a quantity that is not a symbol of the system, use "
            "factor{\"m_2\"} or, if it is a column of a table, runs_of(table, {factor{\"m_2\"}})");
  told = bouncing_balls(), told.for_each_run = [](const run_values& run, auto&) { run["push"]; };
  EXPECT_EQ(refusal(told), "the runs of the study do not vary push");
  told = bouncing_balls(), told.state = {};
  EXPECT_EQ(refusal(told), "speed v has no value");
  told = bouncing_balls(), told.parameters.push_back({g, 9.81});
  EXPECT_EQ(refusal(told), "parameter g has two values");
  told = bouncing_balls(), told.runs = random_runs(3, {{g, normal(1, 0)}}, 1);
  EXPECT_EQ(refusal(told), "invalid distribution normal(1, 0): the deviation must be positive");
  told = bouncing_balls(), told.keep.push_back(times_of("flip", "flips"));
  EXPECT_EQ(refusal(told), "the simulations of the study have no event flip");
  told = bouncing_balls(), told.keep.push_back(at_end<v>("g"));
  EXPECT_EQ(refusal(told), "in the outputs of the study, column g already exists");
  told = bouncing_balls(), told.keep.push_back(at_end<height>());
  EXPECT_EQ(refusal(told), "in the outputs of the study, a column has no name");
  told = bouncing_balls(), told.units.push_back({"hh", "m"});
  EXPECT_EQ(refusal(told), "the study has no hh to assign a unit to");
  told = bouncing_balls(), told.span = {1, 0};
  EXPECT_EQ(refusal(told), "the time span ends at 0, before it begins at 1");
  EXPECT_EQ(refusal(bouncing_balls(), {.reduce = {statistics_of("velocity")}}),
            "the study has no column velocity to reduce");
  for (const reduction& wrong : {histogram_of("g", 1, 1, 5), histogram_of("g", -3, 3, std::size_t(-1)),
                                 histogram_of("g", -3, 3, 0), histogram_of("g", 0, std::nan(""), 5)})
    EXPECT_EQ(refusal(bouncing_balls(), {.reduce = {wrong}}),
              "the histogram of g requires between 1 and 16777216 bins and a start below its end");
  told = bouncing_balls(), told.runs = grid({{g, evenly_spaced(0, 1, std::size_t(-3))}});
  EXPECT_EQ(refusal(told), "the grid has no values for g");
  told = bouncing_balls(), told.runs = runs_of(read_csv("nowhere/runs.csv"));
  EXPECT_EQ(refusal(told), "nowhere/runs.csv cannot be opened: No such file or directory");
}

} // namespace
