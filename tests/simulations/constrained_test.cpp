// builds: clang++ sanitize all
// The beginning of simulations with constraints, and their end if a constraint cannot be satisfied.
#include "simulations/led_bars.hpp"

#include <kanexpr/base/digits.hpp>

#include <cmath>

namespace {

using namespace kanexpr;

using led_bars::led_at;
using led_bars::System;

TEST(constrained, begins_on_its_constraints) {
  using namespace led_bars;
  // The angle and rate of the second bar are computed; the search starts at the given angle.
  for (const double guess : {0.5, -0.5}) {
    const auto run = simulate<System>({{q1, 0.3}, {q2, guess}, {u1, 0.2}}, {}, {0, 1},
                                      {.inputs = led_at(1.5, 0.1), .guesses_dependent = true});
    ASSERT_TRUE(run) << run.cause();
    const auto& first = run.trajectory[0].x;
    EXPECT_NEAR(first[q2], std::copysign(std::acos(1.5 - std::cos(0.3)), guess), 1e-12);
    EXPECT_NEAR(-std::sin(0.3) * 0.2 - std::sin(first[q2]) * first[u2], 0.1, 1e-12);
    EXPECT_LT(std::ranges::max(run.trajectory.constraint_residuals()), 1e-12);
  }
}

TEST(constrained, cannot_begin_where_no_state_is_near) {
  using namespace led_bars;
  const auto run = simulate<System>({{q1, 0.3}, {q2, 0.5}, {u1, 0.2}}, {}, {0, 1},
                                    {.inputs = led_at(2.5, 0), .guesses_dependent = true});
  EXPECT_FALSE(run);
  EXPECT_TRUE(run.trajectory.empty());
  EXPECT_EQ(run.time, 0);
  EXPECT_EQ(run.state, state<System>(0.3, 0.5, 0.2, 0));
  EXPECT_THAT(run.cause(), testing::HasSubstr("the search for the dependent coordinates"));
}

// A value of a dependent coordinate or speed must be consistent, unless it is declared a guess.
TEST(constrained, requires_consistent_values) {
  using namespace led_bars;
  const auto said = [](const given_state<System>& from, const simulation_options<System>& options) {
    const auto run = simulate<System>(from, {}, {0, 0.1}, options);
    EXPECT_EQ(run.trajectory.empty(), !run);
    return std::string(run.cause());
  };
  const double angle = std::acos(1.5 - std::cos(0.3)), rate = -std::sin(0.3) / std::sin(angle);
  const char* advice = "; omit it, declare others dependent<...>, or set guesses_dependent";
  const simulation_options<System> still{.inputs = led_at(1.5, 0)};
  EXPECT_EQ(said({{q1, 0.3}, {q2, angle}, {u1, 1}, {u2, rate}}, still), "");
  EXPECT_EQ(said({{q1, 0.3}, {q2, angle + 2e-5}, {u1, 1}}, still), "");
  EXPECT_EQ(said({{q1, 0.3}, {q2, -0.5}, {u1, 0}}, still),
            "coordinate q2, which is dependent, was given as -0.5, but the constraints require " +
                base::digits(-angle) + advice);
  EXPECT_EQ(said({{q1, 0.3}, {q2, angle}, {u1, 0}, {u2, 30}}, still),
            "speed u2, which is dependent, was given as 30, but the constraints require 0" +
                std::string(advice));
  EXPECT_EQ(said({{q1, 0.3}, {q2, angle}, {u1, 0}, {u2, 30}},
                 {.inputs = led_at(1.5, 0), .guesses_dependent = true}),
            "");
  EXPECT_EQ(said(state<System>(0.3, angle, 1, 0), still),
            "speed u2, which is dependent, was given as 0, but the constraints require " +
                base::digits(rate) + advice);
}

TEST(constrained, requires_consistent_changes_by_a_handler) {
  using namespace led_bars;
  const auto run = [](double to) {
    return simulate<System>(
        {{q1, 0.3}, {q2, 0.5}, {u1, 0.2}}, {}, {0, 1},
        {.inputs = led_at(1.5, 0),
         .guesses_dependent = true,
         .events = {{"soon", [](double t, auto&, auto&, auto&) { return t - 0.5; }, crossing::either,
                     [=](moment<System>& now) {
                       now.x[u2] = to;
                       return after_event::go_on;
                     }}}});
  };
  const auto changed = run(7);
  EXPECT_THAT(
      changed.cause(),
      testing::HasSubstr("speed u2, which is dependent, was given as 7, but the constraints require "));
  EXPECT_THAT(changed.cause(), testing::EndsWith("after the handler of an event"));
}

// The other methods are tested in singular_positions_test.cpp, because they take minutes with sanitizers.
TEST(constrained, ends_at_a_singular_configuration) {
  led_bars::ends_where_they_are_stretched<integrator::bdf>();
}

template <integrator by>
void ends_with_its_last_sample() {
  using namespace led_bars;
  for (const double every : {0.0, 0.3}) {
    const auto run =
        simulate<System, by>({{q1, 0.5}, {q2, -0.5}, {u1, 0}}, {}, {0, 1},
                             {.inputs = led_at(1.8, 0.1), .guesses_dependent = true, .output_every = every});
    ASSERT_TRUE(run) << run.cause();
    EXPECT_EQ(run.trajectory.back().t, run.time);
    EXPECT_EQ(run.trajectory.back().x, run.state);
  }
}

TEST(constrained, ends_with_its_last_sample) {
  ends_with_its_last_sample<integrator::explicit_runge_kutta>();
  ends_with_its_last_sample<integrator::adams>();
  ends_with_its_last_sample<integrator::bdf>();
  ends_with_its_last_sample<integrator::differential_algebraic>();
}

// After a handler the state is projected onto the constraints. This may return a function to the side of zero
// from which it came.
template <integrator by>
void passes_once_what_goes_on() {
  using namespace led_bars;
  const auto count = [](double height, event_handler<System> handler) {
    const auto run = simulate<System, by>({{q1, -0.5}, {q2, 0.5}, {u1, 0}}, {}, {0, 4},
                                          {.inputs = led_at(1.6, 0.02),
                                           .guesses_dependent = true,
                                           .events = {{"height",
                                                       [=](double, const state<System>& at, auto&, auto&) {
                                                         return std::sin(at[q1]) + std::sin(at[q2]) - height;
                                                       },
                                                       crossing::either, std::move(handler)}}});
    EXPECT_TRUE(run) << run.cause();
    return run.events.size();
  };
  for (const double height : {-0.3, -0.1, 0.05, 0.2, 0.3})
    EXPECT_EQ(count(height, [](moment<System>&) {}), count(height, {})) << height;
  EXPECT_GT(count(0.05, {}), 1u);
}

TEST(constrained, passes_an_event_once_if_the_motion_continues) {
  passes_once_what_goes_on<integrator::explicit_runge_kutta>();
  passes_once_what_goes_on<integrator::adams>();
  passes_once_what_goes_on<integrator::bdf>();
  passes_once_what_goes_on<integrator::differential_algebraic>();
}

} // namespace
