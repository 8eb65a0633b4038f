// builds: clang++ all
#include <kanexpr/ensemble.hpp>
#include <models/pendulum_nonminimal.hpp>
#include <models/rotating_tube.hpp>
#include <models/simple_pendulum.hpp>

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

namespace {

using namespace kanexpr;
namespace one = simple_pendulum;

study_in_steps<runge_kutta_4<one::System>> swinging() {
  return {.runs = latin_hypercube(37, {{one::q, uniform(-1, 1)}, {one::m, uniform(0.4, 0.8)}}, 4),
          .state = {{one::u, 0}},
          .parameters = {{one::l, 0.7}, {one::g, 9.81}, {one::c, 0.03}},
          .inputs = {{one::T, 0.5}},
          .span = {.step = 1e-2, .steps = 100},
          .simulation = {.look_every = 10},
          .keep = {at_end<one::q>("angle"), greatest<one::u>("fastest"), least<one::u>("slowest"),
                   at_end<dot(position_of<one::P, one::O>, one::N::y)>("height")},
          .keep_end_state = true};
}

TEST(ensemble_in_steps, keeps_what_single_steps_find) {
  auto told = swinging();
  told.keep_trajectories = true;
  const auto found = ensemble_in_steps<runge_kutta_4<one::System>>(told).run({.threads = 3});
  ASSERT_TRUE(found) << found.cause();
  ASSERT_EQ(found.runs.rows(), 37u);
  EXPECT_EQ(found.failed, 0u);
  for (std::size_t i = 0; i < 37; ++i) {
    state<one::System> x{{one::q, found.runs["q"][i]}, {one::u, 0}};
    const parameter_values<one::System> p{
        {one::l, 0.7}, {one::g, 9.81}, {one::c, 0.03}, {one::m, found.runs["m"][i]}};
    const input_values<one::System> r{{one::T, 0.5}};
    double t = 0, fastest = 0, slowest = 0;
    ASSERT_EQ(found.trajectories[i].rows(), 11u);
    for (int k = 0; k <= 100; ++k) {
      if (k % 10 == 0) {
        fastest = std::max(fastest, x[one::u]), slowest = std::min(slowest, x[one::u]);
        EXPECT_EQ(found.trajectories[i]["t"][std::size_t(k / 10)], t);
        EXPECT_EQ(found.trajectories[i]["u"][std::size_t(k / 10)], x[one::u]);
        EXPECT_EQ(found.trajectories[i]["T"][std::size_t(k / 10)], 0.5);
      }
      if (k < 100) {
        ASSERT_TRUE(runge_kutta_4<one::System>{}(t, x, 1e-2, p, r));
      }
    }
    EXPECT_EQ(found.runs["angle"][i], x[one::q]);
    EXPECT_EQ(found.runs["q_end"][i], x[one::q]);
    EXPECT_EQ(found.runs["u_end"][i], x[one::u]);
    EXPECT_EQ(found.runs["fastest"][i], fastest);
    EXPECT_EQ(found.runs["slowest"][i], slowest);
    EXPECT_EQ(found.runs["t_end"][i], t);
    EXPECT_DOUBLE_EQ(found.runs["height"][i], 0.7 * std::sin(x[one::q]));
  }
}

TEST(ensemble_in_steps, takes_inputs_from_a_function) {
  auto told = swinging();
  told.inputs = {};
  const auto of_all = [](double, const auto& x) {
    using number = typename std::remove_cvref_t<decltype(x)>::Scalar;
    input_values<one::System, number> r;
    r[one::T] = -2.0 * x[one::u];
    return r;
  };
  const auto of_one = [](double, const state<one::System>& x) {
    return input_values<one::System>{{one::T, -2.0 * x[one::u]}};
  };
  const auto batches = ensemble_in_steps(told, of_all).run(), singles = ensemble_in_steps(told, of_one).run();
  ASSERT_TRUE(batches && singles) << batches.cause();
  for (std::size_t i = 0; i < 37; ++i) EXPECT_EQ(batches.runs["q_end"][i], singles.runs["q_end"][i]);
  told.inputs = {{one::T, 0}};
  EXPECT_EQ(ensemble_in_steps(told, of_one).run().cause(),
            "the inputs are specified twice, by the study and by a function");
}

TEST(ensemble_in_steps, serves_single_precision) {
  const auto of = [](auto told) {
    told.runs = grid({{one::q, evenly_spaced(-1, 1, 21)}, {one::m, {0.5}}});
    told.state = {{one::u, 0}};
    told.parameters = {{one::l, 0.7}, {one::g, 9.81}, {one::c, 0.03}};
    told.inputs = {{one::T, 0.5}};
    told.span = {.step = 1e-2, .steps = 100}, told.simulation.look_every = 10;
    told.keep = {at_end<one::q>("angle"), greatest<one::u>("fastest")};
    return told;
  };
  const auto single = ensemble_in_steps(of(study_in_steps<runge_kutta_4<one::System>, float>{})).run();
  const auto doubled = ensemble_in_steps(of(study_in_steps<runge_kutta_4<one::System>>{})).run();
  ASSERT_TRUE(single && doubled) << single.cause();
  for (std::size_t i = 0; i < 21; ++i) {
    EXPECT_NEAR(single.runs["angle"][i], doubled.runs["angle"][i], 1e-5);
    EXPECT_NEAR(single.runs["fastest"][i], doubled.runs["fastest"][i], 1e-5);
    EXPECT_NE(single.runs["angle"][i], doubled.runs["angle"][i]);
    EXPECT_EQ(single.runs["angle"][i], static_cast<float>(single.runs["angle"][i]));
  }
}

TEST(ensemble_in_steps, goes_on_where_a_run_fails) {
  auto told = swinging();
  const double infinite = INFINITY;
  told.runs = grid({{one::q, {0, 0.1, 0.2}}, {one::m, {0.5, infinite, 0}}});
  const auto found = ensemble_in_steps<runge_kutta_4<one::System>>(told).run();
  ASSERT_TRUE(found) << found.cause();
  EXPECT_EQ(found.failed, 6u);
  for (std::size_t i = 0; i < 9; ++i) {
    EXPECT_EQ(found.runs["end"][i], i % 3 == 0 ? 0 : 2);
    EXPECT_EQ(std::isnan(found.runs["q_end"][i]), i % 3 != 0);
    EXPECT_NEAR(found.runs["t_end"][i], i % 3 == 0 ? 1 : 0, 1e-12);
  }
  EXPECT_EQ(found.failures[0].cause, "the value of parameter m is infinite");
  EXPECT_EQ(found.failures[3].run, 5u);
  EXPECT_THAT(found.failures[3].cause, testing::HasSubstr("mass matrix is singular"));
  EXPECT_THAT(found.failures[3].state, testing::ElementsAre(0.1, 0));
}

TEST(ensemble_in_steps, lets_a_function_set_what_goes_together) {
  auto told = swinging();
  told.runs = grid({{one::q, {0.1, 0.2, 0.3}}, {one::m, {0.5}}});
  told.inputs = {};
  told.for_each_run = [](const run_values& run, run_setup<one::System>& first) {
    first.p[one::l] = 2 * first.p[one::m];
    first.r[one::T] = run[one::m] * 9.81 * first.p[one::l] * std::sin(run[one::q]); // at rest
  };
  const auto found = ensemble_in_steps<runge_kutta_4<one::System>>(told).run();
  ASSERT_TRUE(found) << found.cause();
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(found.runs["q_end"][i], found.runs["q"][i], 1e-14);
  told.for_each_run = [](const run_values& run, run_setup<one::System>&) { run["push"]; };
  EXPECT_EQ(ensemble_in_steps<runge_kutta_4<one::System>>(told).run().cause(),
            "the runs of the study do not vary push");
}

TEST(ensemble_in_steps, begins_where_the_constraints_hold) {
  using namespace pendulum_nonminimal;
  study_in_steps<runge_kutta_4<pendulum_nonminimal::System>> told{
      .runs = grid({{q2, {0.5, 1, 3}}}),
      .parameters = {{m, 1}, {L, 2}, {g, 9.81}},
      .span = {.step = 1e-2, .steps = 100},
      .keep = {at_end<q1>("x_end"), at_end<q2>("y_end")}};
  told.state = {{q1, 1}, {u2, 0.1}};
  const auto held = ensemble_in_steps<runge_kutta_4<pendulum_nonminimal::System>>(told).run();
  EXPECT_EQ(held.failed, 3u);
  ASSERT_GT(held.failures.size(), 0u);
  EXPECT_EQ(held.failures[0].cause,
            "coordinate q1, which is dependent, was given as 1, but the constraints require 1.93649167; omit "
            "it, declare others dependent<...>, or set guesses_dependent");
  told.simulation.guesses_dependent = true;
  const auto found = ensemble_in_steps<runge_kutta_4<pendulum_nonminimal::System>>(told).run();
  ASSERT_TRUE(found) << found.cause();
  for (std::size_t i : {0u, 1u})
    EXPECT_NEAR(std::hypot(found.runs["x_end"][i], found.runs["y_end"][i]), 2, 1e-9);
  ASSERT_EQ(found.failed, 1u); // beyond the reach of the pendulum
  EXPECT_EQ(found.failures[0].run, 2u);
}

TEST(ensemble_in_steps, holds_what_dependent_variables_are_given) {
  using namespace pendulum_nonminimal;
  study_in_steps<runge_kutta_4<pendulum_nonminimal::System>> told{.runs = grid({{q1, {1.6, 1.5}}}),
                                                                  .state = {{q2, 1.2}, {u2, 0.1}},
                                                                  .parameters = {{m, 1}, {L, 2}, {g, 9.81}},
                                                                  .span = {.step = 1e-2, .steps = 10},
                                                                  .keep = {at_end<q1>("x_end")}};
  const auto run = [&] { return ensemble_in_steps<runge_kutta_4<pendulum_nonminimal::System>>(told).run(); };
  auto found = run();
  ASSERT_EQ(found.failed, 1u) << found.cause();
  EXPECT_EQ(found.failures[0].run, 1u);
  EXPECT_THAT(found.failures[0].cause,
              testing::StartsWith(
                  "coordinate q1, which is dependent, was given as 1.5, but the constraints require 1.6; "));
  told.for_each_run = [](const run_values&, auto& one) { one.x[u1] = 9; };
  found = run();
  EXPECT_EQ(found.failed, 2u);
  EXPECT_EQ(found.cause().find("all 2 runs failed, the first of them: speed u1, which is dependent, was "
                               "given as 9, but the constraints require -0.075; "),
            0u)
      << found.cause();
}

TEST(ensemble_in_steps, takes_no_rates_that_are_not_those_of_what_is_prescribed) {
  using namespace rotating_tube;
  study_in_steps<runge_kutta_4<rotating_tube::System>> told{
      .runs = grid({{q, {0.5}}}),
      .state = {{u, 0}},
      .parameters = {{m, 1}, {k, 10}, {q0, 0.5}, {g, 9.81}, {c, 0}},
      .inputs = {{theta, 0}, {dot(theta), 2}, {dot(dot(theta)), 0}},
      .span = {.step = 1e-2, .steps = 100}};
  const std::string all = "the run failed, the first of them: prescribed quantity theta ";
  EXPECT_EQ(ensemble_in_steps(told).run().cause(), all + "is constant, but its rate is given as 2");
  told.inputs = {};
  const auto turning_at = [](double rate) {
    return [=](double t, const auto& x) {
      using number = typename std::remove_cvref_t<decltype(x)>::Scalar;
      input_values<rotating_tube::System, number> r;
      r[theta] = 2 * t + 0.0 * x[q], r[dot(theta)] = rate + 0.0 * x[q], r[dot(dot(theta))] = 0.0 * x[q];
      return r;
    };
  };
  EXPECT_TRUE(ensemble_in_steps(told, turning_at(2)).run());
  EXPECT_EQ(ensemble_in_steps(told, turning_at(0)).run().cause(),
            all + "changes at the rate 2 at t = 0.001, but its rate is given as 0");
}

TEST(ensemble_in_steps, says_what_was_told_wrongly) {
  const auto refusal = [](const auto& told) {
    return ensemble_in_steps<runge_kutta_4<one::System>>(told).run().cause();
  };
  auto told = swinging();
  told.span.step = NAN;
  EXPECT_EQ(refusal(told), "the step and the start of a study must be finite");
  told = swinging(), told.span.steps = -1;
  EXPECT_EQ(refusal(told), "the number of steps must be at least 0");
  told = swinging(), told.simulation.look_every = 0;
  EXPECT_EQ(refusal(told), "look_every must be at least 1");
  told = swinging(), told.inputs = {};
  EXPECT_EQ(refusal(told), "input T has no value");
  told = swinging(), told.runs = grid({{"m3", {1}}});
  EXPECT_THAT(refusal(told), testing::StartsWith("the system System has no m3 to vary"));
}

} // namespace
