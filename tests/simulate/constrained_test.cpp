// builds: clang++ sanitize
// How systems with constraints begin, and how they end where a constraint cannot be met.
#include <kanexpr/simulate.hpp>
#include <kanexpr/simulate/prescribe.hpp>

#include <gmock/gmock.h>

#include <cmath>

namespace {

using namespace kanexpr;

// Two bars on a pin; the end of the second is led along a line that stands across the ground.
namespace led_bars {

constexpr coordinate<"q1"> q1;
constexpr coordinate<"q2"> q2;
constexpr speed<"u1"> u1;
constexpr speed<"u2"> u2;
constexpr prescribed<"x"> x;

struct N : inertial_frame<N> {}; // y points up
struct A : rotated<A, N, q1, N::z> {};
struct B : rotated<B, N, q2, N::z> {};
struct O : origin<O, N> {};
struct P : offset<P, O, A::x> {};
struct Q : offset<Q, P, B::x> {};
struct Upper : particle<Upper, P, 1> {};
struct Lower : particle<Lower, Q, 2> {};

struct System
    : kane_system<inertial<N>, coordinates<q1, q2>, speeds<u1, u2>, kinematics<dot(q1) == u1, dot(q2) == u2>,
                  configuration_constraints<dot(position_of<Q, O>, N::x) == x>, dependent<q2, u2>,
                  inputs<x, dot(x), dot(dot(x))>, bodies<Upper, Lower>, loads<gravity<-9.81 * N::y>>> {};

} // namespace led_bars

using led_bars::System;

auto led_at(double start, double speed) {
  return [=](double t, const state<System>&, input_values<System>& r) {
    prescribe(r, led_bars::x, t, [&](auto time) { return start + speed * time; });
  };
}

TEST(constrained, begins_on_its_constraints) {
  using namespace led_bars;
  // The second bar's angle and rate are found; the angle that is given is where the search starts.
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

// What is given for a dependent coordinate or speed holds, or is called a guess.
TEST(constrained, keeps_what_is_given) {
  using namespace led_bars;
  const auto said = [](const given_state<System>& from, const simulation_options<System>& options) {
    const auto run = simulate<System>(from, {}, {0, 0.1}, options);
    EXPECT_EQ(run.trajectory.empty(), !run);
    return std::string(run.cause());
  };
  const double angle = std::acos(1.5 - std::cos(0.3)), rate = -std::sin(0.3) / std::sin(angle);
  const char* advice = "; leave it out, name others dependent<...>, or set guesses_dependent";
  const simulation_options<System> still{.inputs = led_at(1.5, 0)};
  EXPECT_EQ(said({{q1, 0.3}, {q2, angle}, {u1, 1}, {u2, rate}}, still), "");
  EXPECT_EQ(said({{q1, 0.3}, {q2, angle + 2e-5}, {u1, 1}}, still), "");
  EXPECT_EQ(said({{q1, 0.3}, {q2, -0.5}, {u1, 0}}, still),
            "coordinate q2, which is dependent, was given -0.5 and is " + simulated::digits(-angle) + advice);
  EXPECT_EQ(said({{q1, 0.3}, {q2, angle}, {u1, 0}, {u2, 30}}, still),
            "speed u2, which is dependent, was given 30 and is 0" + std::string(advice));
  EXPECT_EQ(said({{q1, 0.3}, {q2, angle}, {u1, 0}, {u2, 30}},
                 {.inputs = led_at(1.5, 0), .guesses_dependent = true}),
            "");
  EXPECT_EQ(said(state<System>(0.3, angle, 1, 0), still),
            "speed u2, which is dependent, was given 0 and is " + simulated::digits(rate) + advice);
}

TEST(constrained, keeps_what_a_handler_changes) {
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
  EXPECT_THAT(changed.cause(), testing::HasSubstr("speed u2, which is dependent, was given 7 and is "));
  EXPECT_THAT(changed.cause(), testing::EndsWith(", after the handler of an event"));
}

// At x = 2 both bars are in line and the constraint is singular; beyond, there is no state.
template <integrator by>
void ends_where_the_bars_are_stretched() {
  using namespace led_bars;
  for (const double every : {0.0, 0.1}) {
    const auto run =
        simulate<System, by>({{q1, 0.5}, {q2, -0.5}, {u1, 0}}, {}, {0, 9},
                             {.inputs = led_at(1.8, 0.1), .guesses_dependent = true, .output_every = every});
    EXPECT_FALSE(run);
    EXPECT_THAT(run.cause(), testing::StartsWith("the simulation ended at t = "));
    EXPECT_THAT(run.cause(), testing::HasSubstr("q1 = "));
    EXPECT_NEAR(run.time, 2, 1e-2);
    ASSERT_GT(run.trajectory.size(), 5u);
    EXPECT_TRUE(run.trajectory.back().x.allFinite());
    EXPECT_EQ(run.trajectory.back().t, run.time);
    EXPECT_EQ(run.trajectory.back().x, run.state);
    EXPECT_LT(std::ranges::max(run.trajectory.constraint_residuals()), 1e-7);
  }
}

TEST(constrained, ends_at_a_singular_configuration) {
  ends_where_the_bars_are_stretched<integrator::explicit_runge_kutta>();
  ends_where_the_bars_are_stretched<integrator::adams>();
  ends_where_the_bars_are_stretched<integrator::bdf>();
  ends_where_the_bars_are_stretched<integrator::differential_algebraic>();
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

// After a handler the state is brought to the constraints again, by which a function may be before zero
// again.
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

TEST(constrained, passes_once_what_goes_on_after_a_handler) {
  passes_once_what_goes_on<integrator::explicit_runge_kutta>();
  passes_once_what_goes_on<integrator::adams>();
  passes_once_what_goes_on<integrator::bdf>();
  passes_once_what_goes_on<integrator::differential_algebraic>();
}

} // namespace
