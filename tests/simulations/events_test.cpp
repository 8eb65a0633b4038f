// builds: clang++ sanitize
#include "simulations/falling_ball.hpp"

#include <kanexpr/simulate.hpp>

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>

namespace {

using namespace kanexpr;
using namespace falling_ball;

constexpr double height = 2, gravity_strength = 9.81, restitution = 0.8;

const std::initializer_list<named_value> start{{h, height}, {v, 0}};
const std::initializer_list<named_value> ball{{m, 0.3}, {g, gravity_strength}};

void bounce(moment<System>& now) { now.x[v] = -restitution * now.x[v]; }

event<System> contact(event_handler<System> handler) {
  return when<System, dot(position_of<P, O>, N::z)>("contact", crossing::falling, std::move(handler));
}

// The ball reaches the ground first after √(2h/g), then after twice that time multiplied by powers of the
// coefficient of restitution.
double time_of_bounce(int k) {
  const double first = std::sqrt(2 * height / gravity_strength);
  double t = first;
  for (int i = 1; i <= k; ++i) t += 2 * first * std::pow(restitution, i);
  return t;
}

template <integrator by>
void bounces_at_the_right_times() {
  const auto run = simulate<System, by>(
      start, ball, {0, 4.5},
      {.relative_tolerance = 1e-12, .absolute_tolerance = 1e-14, .events = {contact(bounce)}});
  ASSERT_TRUE(run) << run.cause();
  ASSERT_GE(run.events.size(), 6u);
  for (std::size_t k = 0; k < run.events.size(); ++k)
    EXPECT_NEAR(run.events[k].t, time_of_bounce(static_cast<int>(k)), 1e-10) << k;
  EXPECT_GT(time_of_bounce(static_cast<int>(run.events.size())), 4.5);
  EXPECT_EQ(run.statistics.events, static_cast<long>(run.events.size()));
}

TEST(events, are_found_where_a_ball_bounces) {
  bounces_at_the_right_times<integrator::adams>();
  bounces_at_the_right_times<integrator::bdf>();
  bounces_at_the_right_times<integrator::explicit_runge_kutta>();
  bounces_at_the_right_times<integrator::implicit_runge_kutta>();
  bounces_at_the_right_times<integrator::differential_algebraic>();
}

TEST(events, leave_the_state_before_and_after) {
  const auto run = simulate<System>(start, ball, {0, 1}, {.events = {contact(bounce)}});
  ASSERT_TRUE(run) << run.cause();
  ASSERT_EQ(run.events.size(), 1u);
  const double t = run.events[0].t, before = -std::sqrt(2 * height * gravity_strength);
  std::vector<double> speeds;
  for (const auto& s : run.trajectory)
    if (s.t == t) speeds.push_back(s.x[v]);
  ASSERT_EQ(speeds.size(), 2u);
  EXPECT_NEAR(speeds[0], before, 1e-7);
  EXPECT_NEAR(speeds[1], -restitution * before, 1e-7);
  EXPECT_EQ(run.trajectory.at(t)->x[v], speeds[1]);
}

TEST(events, may_stop_a_simulation) {
  const auto run = simulate<System>(start, ball, {0, 9}, {.events = {contact(after_event::stop)}});
  ASSERT_TRUE(run) << run.cause();
  EXPECT_TRUE(run.stopped_by_event);
  EXPECT_NEAR(run.time, time_of_bounce(0), 1e-9);
  EXPECT_NEAR(run.state[h], 0, 1e-9);
}

// At the highest point after a bounce the speed crosses zero; the event has no handler.
TEST(events, without_a_handler_are_recorded) {
  const auto run =
      simulate<System>({{h, 0}, {v, 3}}, ball, {0, 0.6},
                       {.events = {when<System, v>("top", crossing::falling),
                                   when<System, v>("bottom", crossing::rising),
                                   {"halfway", [](double t, auto&, auto&, auto&) { return t - 0.5; }}}});
  ASSERT_TRUE(run) << run.cause();
  ASSERT_EQ(run.events.size(), 2u);
  EXPECT_EQ(run.events[0].name, "top");
  EXPECT_NEAR(run.events[0].t, 3 / gravity_strength, 1e-10);
  EXPECT_EQ(run.events[1].name, "halfway");
  EXPECT_NEAR(run.events[1].t, 0.5, 1e-12);
  EXPECT_EQ(run.time, 0.6);
}

// Sums of tenths differ from 0.3 and 0.6 in the last bit, so no time remains between the event and the next
// sample or the end.
template <integrator by>
void goes_on_right_before_a_sample() {
  const auto kick = [](moment<System>& now) { now.x[v] += 1; };
  const auto run = simulate<System, by>(
      start, ball, {0, 0.6},
      {.output_every = 0.1,
       .events = {{"first", [](double t, auto&, auto&, auto&) { return t - 0.3; }, crossing::either, kick},
                  {"last", [](double t, auto&, auto&, auto&) { return t - 0.6; }, crossing::either, kick}}});
  ASSERT_TRUE(run) << run.cause();
  EXPECT_EQ(run.trajectory.size(), 7u);
  EXPECT_EQ(run.time, 0.6);
  EXPECT_NEAR(run.trajectory[5].x[v], 1 - gravity_strength * 0.5, 1e-7);
}

TEST(events, may_occur_right_before_a_sample) {
  goes_on_right_before_a_sample<integrator::adams>();
  goes_on_right_before_a_sample<integrator::bdf>();
  goes_on_right_before_a_sample<integrator::explicit_runge_kutta>();
  goes_on_right_before_a_sample<integrator::implicit_runge_kutta>();
  goes_on_right_before_a_sample<integrator::differential_algebraic>();
}

// A handler that leaves the ball at a state at which the event occurs again immediately.
TEST(events, that_occur_faster_and_faster_end_a_simulation) {
  const auto run = simulate<System>(start, ball, {0, 20}, {.events = {contact(bounce)}});
  EXPECT_FALSE(run);
  EXPECT_THAT(run.cause(), testing::HasSubstr("events occur faster and faster"));
  EXPECT_NEAR(run.time, 9 * time_of_bounce(0), 1e-3); // the sum of all flights
  EXPECT_GT(run.trajectory.size(), 100u);
}

TEST(events, whose_handler_throws_end_a_simulation) {
  const auto run = simulate<System>(
      start, ball, {0, 9},
      {.events = {contact([](moment<System>&) { throw std::runtime_error("the floor broke"); })}});
  EXPECT_FALSE(run);
  EXPECT_THAT(run.cause(), testing::StartsWith("the simulation ended at t = 0.638"));
  EXPECT_THAT(run.cause(), testing::HasSubstr("h = "));
  EXPECT_THAT(run.cause(), testing::EndsWith(": the handler of the event contact threw: the floor broke"));
  EXPECT_GT(run.trajectory.size(), 3u);
  EXPECT_NEAR(run.trajectory.back().t, time_of_bounce(0), 1e-9);
}

TEST(events, whose_handler_leaves_no_state_end_a_simulation) {
  const auto run =
      simulate<System>(start, ball, {0, 9},
                       {.events = {contact([](moment<System>& now) { now.x[v] = std::sqrt(now.x[v]); })}});
  EXPECT_THAT(run.cause(), testing::EndsWith("the handler of an event left a state that is not finite"));
  EXPECT_TRUE(run.state.allFinite());
}

TEST(events, whose_value_is_not_a_number_end_a_simulation) {
  const auto run = simulate<System>(start, ball, {0, 9},
                                    {.events = {{"depth", [](double, const state<System>& x, auto&, auto&) {
                                                   return std::sqrt(x[h] - 1);
                                                 }}}});
  EXPECT_FALSE(run);
  EXPECT_THAT(run.cause(), testing::HasSubstr("the value of the event depth is not a number"));
  EXPECT_GT(run.trajectory.size(), 1u);
}

// Integrators detect changes of sign. A ball that begins on the ground, or below it by less than the
// tolerance, touches it immediately if it moves down.
template <integrator by>
void takes_what_is_zero_at_the_start_by_its_direction() {
  struct beginning {
    double at, speed;
    bool meets_the_ground;
  };
  for (const beginning s : {beginning{0, -3, true}, beginning{-1e-17, -3, true}, beginning{-5e-11, -3, true},
                            beginning{0, 3, false}, beginning{1e-17, 3, false}, beginning{-1e-17, 3, false},
                            beginning{-1, -3, false}}) {
    const auto run = simulate<System, by>({{h, s.at}, {v, s.speed}}, ball, {0, 0.2},
                                          {.output_every = 0.1, .events = {contact(bounce)}});
    ASSERT_TRUE(run) << run.cause();
    ASSERT_EQ(run.events.size(), s.meets_the_ground ? 1u : 0u) << s.at << ' ' << s.speed;
    const double speed = s.meets_the_ground ? -restitution * s.speed : s.speed;
    EXPECT_NEAR(run.state[v], speed - gravity_strength * 0.2, 1e-8);
    for (const occurrence& e : run.events) EXPECT_EQ(e.t, 0);
  }
}

TEST(events, at_the_start_depend_on_their_direction) {
  takes_what_is_zero_at_the_start_by_its_direction<integrator::adams>();
  takes_what_is_zero_at_the_start_by_its_direction<integrator::bdf>();
  takes_what_is_zero_at_the_start_by_its_direction<integrator::explicit_runge_kutta>();
  takes_what_is_zero_at_the_start_by_its_direction<integrator::implicit_runge_kutta>();
  takes_what_is_zero_at_the_start_by_its_direction<integrator::differential_algebraic>();
}

// Nothing supports a ball that a handler brings to rest, so the handler must stop the simulation.
template <integrator by>
void does_not_let_a_ball_at_rest_fall_through_the_ground() {
  for (const double at : {0.0, -1e-17, 1e-17}) {
    const auto stopped =
        simulate<System, by>({{h, at}, {v, 0}}, ball, {0, 1}, {.events = {contact(after_event::stop)}});
    ASSERT_TRUE(stopped) << stopped.cause();
    EXPECT_TRUE(stopped.stopped_by_event);
    EXPECT_NEAR(stopped.time, 0, 1e-8);
    const auto fallen = simulate<System, by>({{h, at}, {v, 0}}, ball, {0, 1}, {.events = {contact(bounce)}});
    EXPECT_FALSE(fallen);
    EXPECT_THAT(fallen.cause(), testing::HasSubstr("events occur faster and faster"));
    EXPECT_GE(fallen.state[h], -1e-9);
    EXPECT_EQ(fallen.events[0].name, "contact");
  }
  const auto caught = simulate<System, by>(start, ball, {0, 9},
                                           {.events = {contact([](moment<System>& now) { now.x[v] = 0; })}});
  EXPECT_FALSE(caught);
  EXPECT_THAT(caught.cause(), testing::HasSubstr("events occur faster and faster"));
  EXPECT_NEAR(caught.time, time_of_bounce(0), 1e-4);
  EXPECT_GE(caught.state[h], -1e-9);
}

TEST(events, do_not_let_a_ball_at_rest_fall_through_the_ground) {
  does_not_let_a_ball_at_rest_fall_through_the_ground<integrator::adams>();
  does_not_let_a_ball_at_rest_fall_through_the_ground<integrator::bdf>();
  does_not_let_a_ball_at_rest_fall_through_the_ground<integrator::explicit_runge_kutta>();
  does_not_let_a_ball_at_rest_fall_through_the_ground<integrator::implicit_runge_kutta>();
  does_not_let_a_ball_at_rest_fall_through_the_ground<integrator::differential_algebraic>();
}

// The ball dives into a fluid: its speed is halved, and it continues to fall.
TEST(events, occur_once_if_the_motion_continues) {
  const auto run = simulate<System>(
      start, ball, {0, 2}, {.events = {contact([](moment<System>& now) { now.x[v] = now.x[v] / 2; })}});
  ASSERT_TRUE(run) << run.cause();
  EXPECT_EQ(run.events.size(), 1u);
  EXPECT_LT(run.state[h], -2);
}

// The ball rests on the ground without gravity until it is pushed down.
TEST(events, that_are_zero_since_the_start_occur_when_they_leave_zero) {
  const auto run =
      simulate<System>({{h, 0}, {v, 0}}, {{m, 0.3}, {g, 0}}, {0, 2},
                       {.events = {contact(bounce),
                                   {"pushed", [](double t, auto&, auto&, auto&) { return t - 1; },
                                    crossing::rising, [](moment<System>& now) { now.x[v] = -1; }}}});
  ASSERT_EQ(run.events.size(), 2u) << run.cause();
  EXPECT_EQ(run.events[1].name, "contact");
  EXPECT_EQ(run.events[1].t, run.events[0].t);
  EXPECT_NEAR(run.state[h], restitution, 1e-8);
}

// A function that is zero at the start leaves zero within a step, by a jump or continuously.
template <integrator by>
void happen_where_a_function_leaves_zero() {
  for (const bool jumps : {true, false}) {
    int handled = 0;
    const event<System> leaves(
        "leaves", [=](double t, auto&, auto&, auto&) { return t < 0.5 ? 0
                                                              : jumps ? 1
                                                                      : t - 0.5; },
        crossing::rising, [&](moment<System>&) { ++handled; });
    const auto run = simulate<System, by>(start, ball, {0, 0.6}, {.events = {leaves}});
    ASSERT_TRUE(run) << run.cause();
    ASSERT_EQ(run.events.size(), 1u) << jumps;
    EXPECT_EQ(handled, 1);
    EXPECT_NEAR(run.events[0].t, 0.5, 1e-14);
    const auto at = run.trajectory.at(run.events[0].t);
    EXPECT_NEAR(at->x[h], height - gravity_strength * 0.125, 1e-7);
    EXPECT_NEAR(run.state[h], height - gravity_strength * 0.18, 1e-7);
  }
}

TEST(events, occur_when_a_function_leaves_zero) {
  happen_where_a_function_leaves_zero<integrator::adams>();
  happen_where_a_function_leaves_zero<integrator::bdf>();
  happen_where_a_function_leaves_zero<integrator::explicit_runge_kutta>();
  happen_where_a_function_leaves_zero<integrator::implicit_runge_kutta>();
  happen_where_a_function_leaves_zero<integrator::differential_algebraic>();
}

TEST(events, at_the_start_occur_in_a_span_of_zero_length) {
  for (const double speed : {-3.0, 0.0, 3.0}) {
    const auto run =
        simulate<System>({{h, 0}, {v, speed}}, ball, {0, 0}, {.events = {contact(after_event::stop)}});
    ASSERT_TRUE(run) << run.cause();
    EXPECT_EQ(run.events.size(), speed > 0 ? 0u : 1u) << speed;
    EXPECT_EQ(run.stopped_by_event, speed <= 0);
  }
}

TEST(events, of_a_function_that_is_always_zero_do_not_occur) {
  for (const crossing direction : {crossing::rising, crossing::falling, crossing::either}) {
    const auto run = simulate<System>(
        start, ball, {0, 1},
        {.events = {{"nothing", [](double, auto&, auto&, auto&) { return 0.0; }, direction}}});
    ASSERT_TRUE(run) << run.cause();
    EXPECT_TRUE(run.events.empty());
  }
}

TEST(events, at_the_end_occur) {
  const auto run =
      simulate<System>(start, ball, {0, 0.25},
                       {.events = {{"end", [](double t, auto&, auto&, auto&) { return t - 0.25; },
                                    crossing::rising, [](moment<System>& now) { now.x[v] = 7; }}}});
  ASSERT_TRUE(run) << run.cause();
  ASSERT_EQ(run.events.size(), 1u);
  EXPECT_EQ(run.time, 0.25);
  EXPECT_EQ(run.state[v], 7);
  EXPECT_EQ(run.trajectory.back().x[v], 7);
}

// Rounding gives each event a different time.
TEST(events, may_coincide) {
  for (const event_handler<System>& handler :
       {event_handler<System>(), event_handler<System>([](moment<System>&) {})}) {
    std::vector<event<System>> many;
    for (int i = 0; i < 60; ++i)
      many.push_back({"event " + std::to_string(i),
                      [=](double t, auto&, auto&, auto&) { return t - (0.3 + 2e-14 * i); }, crossing::either,
                      handler});
    const auto run = simulate<System>(start, ball, {0, 1}, {.events = many});
    ASSERT_TRUE(run) << run.cause();
    ASSERT_EQ(run.events.size(), 60u);
    for (std::size_t i = 0; i < 60; ++i) EXPECT_EQ(run.events[i].name, many[i].name);
  }
}

// The time at which the function reached zero cannot be found.
TEST(events, that_stay_at_zero_end_a_simulation) {
  const auto run = simulate<System>(
      start, ball, {0, 1},
      {.events = {{"height", [](double, const state<System>& x, auto&, auto&) { return std::max(x[h], 0.0); },
                   crossing::falling, bounce}}});
  EXPECT_FALSE(run);
  EXPECT_THAT(run.cause(), testing::EndsWith("the event height stays at zero; it must pass through zero"));
  EXPECT_TRUE(run.events.empty());
}

TEST(events, without_a_value_at_the_start_end_a_simulation) {
  int asked = 0;
  const auto run =
      simulate<System>(start, ball, {0, 1}, {.events = {{"odd", [&](double, auto&, auto&, auto&) -> double {
                                                           if (asked++ == 0)
                                                             throw std::runtime_error("not ready");
                                                           return 1;
                                                         }}}});
  EXPECT_FALSE(run);
  EXPECT_THAT(run.cause(), testing::EndsWith("the event odd threw: not ready"));
  EXPECT_EQ(run.trajectory.size(), 1u);
}

// Even if the steps between them are short, and they change slowly compared with the other entries of the
// state.
TEST(events, may_follow_one_another_closely) {
  std::vector<event<System>> close;
  for (int i = 0; i < 40; ++i)
    close.push_back({"event " + std::to_string(i),
                     [=](double, const state<System>& x, auto&, auto&) { return x[h] - (1 - 1e-12 * i); },
                     crossing::falling, [](moment<System>&) {}});
  const auto run =
      simulate<System>({{h, 1 + 1e-6}, {v, -1e-3}}, {{m, 0.3}, {g, 0}}, {0, 1}, {.events = close});
  ASSERT_TRUE(run) << run.cause();
  EXPECT_EQ(run.events.size(), 40u);
}

// The same motion with different clock origins: events of the state and of the time, with and without
// handlers, and samples at requested times.
template <integrator by>
void is_the_same_at_any_time() {
  std::optional<simulation<System>> first;
  for (const double from : {0.0, 1.7e9, -3e10}) {
    simulation_options<System> o{.output_times = {from + 0.25, from + 0.75}, .events = {contact(bounce)}};
    for (const auto& [name, after] : {std::pair{"alone", 0.5}, std::pair{"kick", 0.875}}) {
      event<System> at(name, [=](double t, auto&, auto&, auto&) { return t - (from + after); });
      if (name == std::string("kick")) at.handler = [](moment<System>& now) { now.x[v] += 1; };
      o.events.push_back(at);
    }
    const auto run = simulate<System, by>(start, ball, {from, from + 1}, o);
    ASSERT_TRUE(run) << run.cause();
    if (!first) first = run;
    EXPECT_EQ(run.time, from + 1);
    ASSERT_EQ(run.events.size(), 3u) << from;
    const double seen = 1e-8 + 4e-16 * std::abs(from); // of time
    EXPECT_EQ(run.events[0].name, "alone");
    EXPECT_NEAR(run.events[1].t - from, first->events[1].t, seen);
    EXPECT_NEAR(run.events[2].t - from, 0.875, seen);
    EXPECT_THAT(run.trajectory.times(), testing::ElementsAre(from + 0.25, from + 0.75));
    for (std::size_t i = 0; i < 2; ++i)
      EXPECT_NEAR(run.trajectory[i].x[h], first->trajectory[i].x[h], 1e-7) << from;
    EXPECT_NEAR(run.state[h], first->state[h], 1e-7 + 20 * 4e-16 * std::abs(from));
  }
}

TEST(events, are_those_of_the_same_motion_at_any_time) {
  is_the_same_at_any_time<integrator::adams>();
  is_the_same_at_any_time<integrator::bdf>();
  is_the_same_at_any_time<integrator::explicit_runge_kutta>();
  is_the_same_at_any_time<integrator::implicit_runge_kutta>();
  is_the_same_at_any_time<integrator::differential_algebraic>();
}

template <integrator by>
void falls_freely_at_any_time() {
  for (const double from : {0.0, -1e3, 1.7e9, 1e12})
    for (const double length : {1.0, 0x1p-10}) {
      const auto run = simulate<System, by>(start, ball, {from, from + length});
      if (from == 1e12 && length < 1) {
        EXPECT_EQ(
            run.cause(),
            "the time span, 0.0009765625 s, is too short: doubles near 1e+12 are 0.000122070312 s apart");
        continue;
      }
      ASSERT_TRUE(run) << run.cause();
      EXPECT_NEAR(run.state[v] / (-gravity_strength * length), 1, 1e-7) << from << ' ' << length;
      EXPECT_NEAR(run.state[h], height - gravity_strength * length * length / 2, 1e-7);
    }
  const auto lost = simulate<System, by>({{h, 1e308}, {v, 1e308}}, ball, {0, 1});
  EXPECT_THAT(lost.cause(), testing::EndsWith(": h overflows double"));
  EXPECT_TRUE(lost.state.allFinite());
}

TEST(events, are_not_needed_for_free_fall_at_any_time) {
  falls_freely_at_any_time<integrator::adams>();
  falls_freely_at_any_time<integrator::bdf>();
  falls_freely_at_any_time<integrator::explicit_runge_kutta>();
  falls_freely_at_any_time<integrator::implicit_runge_kutta>();
  falls_freely_at_any_time<integrator::differential_algebraic>();
}

} // namespace
