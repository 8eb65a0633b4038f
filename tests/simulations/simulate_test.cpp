// builds: clang++ sanitize
// The arguments of a simulation and its result.
#include <kanexpr/simulate.hpp>

#include <models/simple_pendulum.hpp>

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

namespace {

using namespace kanexpr;
using namespace simple_pendulum;

const std::initializer_list<named_value> start{{q, 0.3}, {u, 0}};
const std::initializer_list<named_value> numbers{{m, 1}, {l, 1}, {g, 9.81}, {c, 0.1}};

simulation<System> run_with(const simulation_options<System>& options, time_span span = {0, 1}) {
  return simulate<System>(start, numbers, span, options);
}
std::string cause_with(const simulation_options<System>& options, time_span span = {0, 1}) {
  const auto run = run_with(options, span);
  EXPECT_TRUE(run.trajectory.empty());
  EXPECT_EQ(run.statistics.rate_evaluations, 0);
  return run.cause();
}

const std::initializer_list<named_value> idle{{T, 0}};

TEST(simulate, takes_values_by_name) {
  const std::map<std::string, double> from_a_file{{"m", 1}, {"l", 1}, {"g", 9.81}, {"c", 0.1}};
  state<System> x;
  x[q] = 0.3;
  const auto one = run_with({.inputs = idle});
  const auto other = simulate<System>(x, from_a_file, {0, 1}, {.inputs = input_values<System>::Zero()});
  ASSERT_TRUE(one) << one.cause();
  ASSERT_TRUE(other) << other.cause();
  EXPECT_EQ(one.state, other.state);
}

TEST(simulate, reports_missing_values_before_the_first_step) {
  EXPECT_EQ(simulate<System>({{q, 0.3}}, numbers, {0, 1}, {.inputs = idle}).cause(), "speed u has no value");
  EXPECT_EQ(simulate<System>(start, {{m, 1}, {l, 1}, {g, 9.81}}, {0, 1}, {.inputs = idle}).cause(),
            "parameter c has no value");
  EXPECT_EQ(
      simulate<System>(start, {{m, 1}, {l, 1}, {g, 9.81}, {c, 0}, {m, 2}}, {0, 1}, {.inputs = idle}).cause(),
      "parameter m has two values");
  EXPECT_EQ(cause_with({}), "input T has no value");
}

TEST(simulate, rejects_invalid_options) {
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               infinite = std::numeric_limits<double>::infinity();
  EXPECT_EQ(cause_with({.inputs = idle}, {1, 0}), "the time span ends at 0, before it begins at 1");
  EXPECT_EQ(cause_with({.inputs = idle}, {0, nan}), "the time span is not finite");
  EXPECT_EQ(cause_with({.inputs = idle, .relative_tolerance = 0}), "a tolerance must be positive");
  EXPECT_EQ(cause_with({.inputs = idle, .absolute_tolerance = 0}), "a tolerance must be positive");
  EXPECT_EQ(cause_with({.inputs = idle, .absolute_tolerances = {{u, -1}}}), "a tolerance must be positive");
  EXPECT_EQ(cause_with({.inputs = idle, .absolute_tolerances = {{m, 1}}}),
            "in the tolerances, parameter m is not an entry of the state vector of System");
  EXPECT_EQ(cause_with({.inputs = idle, .output_every = -1}),
            "the time between two samples must be positive");
  EXPECT_EQ(cause_with({.inputs = idle, .output_times = {0.5, 2}}),
            "the output time 2 is outside the time span");
  EXPECT_EQ(cause_with({.inputs = idle, .output_times = {0.5, 0.2}}),
            "the output time 0.2 is listed after 0.5");
  EXPECT_EQ(cause_with({.inputs = idle}, {-1e308, 1e308}), "the time span overflows double");
  EXPECT_EQ(cause_with({.inputs = idle}, {1e9, 1e9 + 0x1p-20}),
            "the time span, 9.53674316e-07 s, is too short: doubles near 1e+09 are 1.1920929e-07 s apart");
  EXPECT_EQ(cause_with({.inputs = idle}, {0, 1e-300}),
            "the time span, 1e-300 s, is too short to be divided into steps");
  EXPECT_EQ(cause_with({.inputs = idle, .greatest_step = 1e-300}),
            "the greatest step, 1e-300, is lost to rounding in a span of 1 s");
  EXPECT_EQ(cause_with({.inputs = idle, .relative_tolerance = nan}), "a tolerance is not finite");
  EXPECT_EQ(cause_with({.inputs = idle, .absolute_tolerance = infinite}), "a tolerance is not finite");
  EXPECT_EQ(cause_with({.inputs = idle, .relative_tolerance = 1}),
            "the relative tolerance is 1; it must be below 1");
  EXPECT_EQ(cause_with({.inputs = idle, .output_every = nan}), "the time between two samples is not finite");
  EXPECT_EQ(cause_with({.inputs = idle, .output_every = infinite}),
            "the time between two samples is not finite");
  for (const double fine : {1e-16, 1e-300, std::numeric_limits<double>::denorm_min()})
    EXPECT_THAT(cause_with({.inputs = idle, .output_every = fine}),
                testing::EndsWith(" s are too closely spaced for times near 1 in double precision"));
  EXPECT_THAT(cause_with({.inputs = idle, .output_every = 1e-6}, {0, 1e9}),
              testing::AllOf(testing::StartsWith("samples every 1e-06 s take "),
                             testing::HasSubstr(" GB, and the machine has "),
                             testing::EndsWith(" GB; pass them to each_sample, with keep = false")));
  EXPECT_EQ(cause_with({.inputs = idle, .first_step = infinite}), "a step size is not finite");
  EXPECT_EQ(cause_with({.inputs = idle, .least_step = -1}), "a step size must be positive");
  EXPECT_EQ(cause_with({.inputs = idle, .least_step = 0.2, .greatest_step = 0.1}),
            "the least step, 0.2, is longer than the greatest, 0.1");
  for (const long steps : {0L, -1L})
    EXPECT_EQ(cause_with({.inputs = idle, .most_steps = steps}),
              "the maximum number of steps must be positive");
  EXPECT_EQ(cause_with({.inputs = idle, .keep = false}), "samples are neither kept nor passed to a function");
  EXPECT_EQ(cause_with({.inputs = idle, .greatest_step = nan}), "a step size is not finite");
  EXPECT_EQ(cause_with({.inputs = idle, .events = {{"odd", nullptr}}}), "the event odd has no function");
}

TEST(simulate, takes_samples_at_requested_times) {
  const auto steps = run_with({.inputs = idle});
  EXPECT_EQ(steps.trajectory.front().t, 0);
  EXPECT_EQ(steps.trajectory.back().t, 1);
  EXPECT_EQ(static_cast<long>(steps.trajectory.size()), steps.statistics.steps + 1);

  const auto regular = run_with({.inputs = idle, .output_every = 0.3});
  EXPECT_THAT(regular.trajectory.times(), testing::ElementsAre(0, 0.3, 0.6, testing::DoubleEq(0.9), 1));
  const auto tenths = run_with({.inputs = idle, .output_every = 0.1});
  EXPECT_EQ(tenths.trajectory.size(), 11u);

  const auto listed = run_with({.inputs = idle, .output_times = {0.25, 0.5}});
  EXPECT_THAT(listed.trajectory.times(), testing::ElementsAre(0.25, 0.5));
  EXPECT_EQ(listed.time, 1);
  EXPECT_LT((listed.state - steps.state).norm(), 1e-7);
  EXPECT_LT((listed.trajectory[1].x - steps.trajectory.at(0.5)->x).norm(), 1e-6);
}

TEST(simulate, over_no_time_returns_the_start) {
  const auto run = run_with({.inputs = idle}, {2, 2});
  ASSERT_TRUE(run) << run.cause();
  ASSERT_EQ(run.trajectory.size(), 1u);
  EXPECT_EQ(run.trajectory[0].x[q], 0.3);
}

TEST(simulate, passes_samples_on_without_keeping_them) {
  std::vector<double> seen;
  const auto run =
      run_with({.inputs = idle, .output_every = 0.25, .keep = false, .each_sample = [&](const auto& s) {
                  seen.push_back(s.t);
                }});
  ASSERT_TRUE(run) << run.cause();
  EXPECT_TRUE(run.trajectory.empty());
  EXPECT_THAT(seen, testing::ElementsAre(0, 0.25, 0.5, 0.75, 1));
}

TEST(simulate, reports_its_progress) {
  std::vector<double> told;
  const auto run = run_with({.inputs = idle, .progress = [&](double t, time_span span) {
                               EXPECT_EQ(span.to, 1);
                               told.push_back(t);
                             }});
  EXPECT_EQ(static_cast<long>(told.size()), run.statistics.steps);
  EXPECT_EQ(told.back(), 1);
}

TEST(simulate, respects_the_greatest_step) {
  const auto run = run_with({.inputs = idle, .greatest_step = 0.01});
  EXPECT_GE(run.statistics.steps, 100);
}

// A pendulum that is driven so strongly that no step is short enough.
TEST(simulate, ends_when_the_step_size_collapses) {
  const auto run = run_with({.inputs = [](double t) {
    input_values<System> r;
    r[T] = 1 / (0.5 - t) / (0.5 - t) / (0.5 - t);
    return r;
  }});
  EXPECT_FALSE(run);
  EXPECT_THAT(run.cause(), testing::HasSubstr("with q = "));
  EXPECT_NEAR(run.time, 0.5, 1e-2);
  EXPECT_GT(run.trajectory.size(), 50u);
  EXPECT_TRUE(run.trajectory.back().x.allFinite());
}

TEST(simulate, names_the_least_step_that_ends_it) {
  EXPECT_THAT(run_with({.inputs = idle, .least_step = 0.5}).cause(),
              testing::EndsWith("; the least step is 0.5"));
}

TEST(simulate, ends_after_the_maximum_number_of_steps) {
  EXPECT_THAT(run_with({.inputs = idle, .most_steps = 5}).cause(),
              testing::EndsWith("the maximum number of steps was reached"));
  const auto run = run_with({.inputs = idle, .output_times = {1}, .most_steps = 5});
  EXPECT_THAT(run.cause(), testing::EndsWith("the maximum number of steps was reached"));
}

TEST(simulate, ends_when_a_user_function_throws) {
  const auto run = run_with({.inputs = idle, .each_sample = [](const auto& s) {
                               if (s.t > 0.5) throw 7;
                             }});
  EXPECT_THAT(run.cause(), testing::EndsWith("threw something that is not a std::exception"));
  EXPECT_GT(run.trajectory.size(), 3u);
}

// If a simulation fails, the reported time and state are those of its last sample.
void expect_one_end(const simulation<System>& run, const std::vector<sample<System>>& handed) {
  EXPECT_FALSE(run);
  ASSERT_FALSE(run.trajectory.empty());
  EXPECT_EQ(run.trajectory.back().t, run.time) << run.cause();
  EXPECT_EQ(run.trajectory.back().x, run.state) << run.cause();
  ASSERT_EQ(handed.size(), run.trajectory.size());
  EXPECT_EQ(handed.back().t, run.time);
}

template <integrator by>
void ends_at_one_state() {
  const auto singular = [](double t) {
    return input_values<System>::Constant(1 / (0.5 - t) / (0.5 - t) / (0.5 - t));
  };
  const auto from_half = [](double t) {
    return input_values<System>::Constant(t < 0.5 ? 1 : std::sqrt(0.5 - t));
  };
  const auto throwing = [](double t) {
    if (t > 0.5) throw std::runtime_error("no more torque");
    return input_values<System>::Zero();
  };
  std::vector<sample<System>> handed;
  for (const double every : {0.0, 0.02, 0.7})
    for (const input_source<System>& inputs :
         {input_source<System>(singular), input_source<System>(from_half), input_source<System>(throwing)}) {
      handed.clear();
      const auto run =
          simulate<System, by>(start, numbers, {0, 1},
                               {.inputs = inputs, .output_every = every, .each_sample = [&](const auto& s) {
                                  handed.push_back(s);
                                }});
      expect_one_end(run, handed);
      EXPECT_NEAR(run.time, 0.5, 0.1);
      EXPECT_LE(run.time, 0.5);
    }
  for (const double every : {0.0, 0.02, 0.7}) {
    handed.clear();
    simulation_options<System> o{.inputs = idle, .output_every = every, .each_sample = [&](const auto& s) {
                                   handed.push_back(s);
                                   if (s.t > 0.5) throw 7;
                                 }};
    expect_one_end(simulate<System, by>(start, numbers, {0, 1}, o), handed);
    o.each_sample = [&](const auto& s) { handed.push_back(s); };
    o.most_steps = 5;
    handed.clear();
    expect_one_end(simulate<System, by>(start, numbers, {0, 1}, o), handed);
    o.most_steps = 10000;
    o.events = {{"odd", [](double t, auto&, auto&, auto&) { return t < 0.5 ? 1 : std::sqrt(0.5 - t); }}};
    handed.clear();
    expect_one_end(simulate<System, by>(start, numbers, {0, 1}, o), handed);
  }
}

TEST(simulate, ends_at_its_last_sample_if_it_fails) {
  ends_at_one_state<integrator::adams>();
  ends_at_one_state<integrator::explicit_runge_kutta>();
  ends_at_one_state<integrator::differential_algebraic>();
}

template <integrator by>
void leaves_the_start_where_the_first_step_fails() {
  const auto later = [](double t) { return input_values<System>::Constant(t == 0 ? 1 : std::sqrt(-t)); };
  for (const double every : {0.0, 0.1}) {
    const auto run = simulate<System, by>(start, numbers, {0, 1}, {.inputs = later, .output_every = every});
    EXPECT_FALSE(run);
    EXPECT_EQ(run.time, 0);
    EXPECT_EQ(run.state[q], 0.3);
    EXPECT_EQ(run.state[u], 0);
    EXPECT_EQ(run.trajectory.size(), 1u);
  }
}

TEST(simulate, ends_at_the_start_if_the_first_step_fails) {
  leaves_the_start_where_the_first_step_fails<integrator::adams>();
  leaves_the_start_where_the_first_step_fails<integrator::explicit_runge_kutta>();
  leaves_the_start_where_the_first_step_fails<integrator::differential_algebraic>();
}

} // namespace
