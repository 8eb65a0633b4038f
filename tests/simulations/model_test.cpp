// builds: clang++ all
// Run-time models, derived from types or from a builder, move like the compile-time system.
#include "runtime/built_pendulum.hpp"
#include "simulations/falling_ball.hpp"

#include <kanexpr/runtime/builder.hpp>
#include <kanexpr/simulations/model.hpp>
#include <kanexpr/simulations/prescribe.hpp>
#include <kanexpr/simulations/tables/csv.hpp>

#include <models/four_bar.hpp>
#include <models/rotating_tube.hpp>
#include <models/simple_pendulum.hpp>

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace kanexpr;
using runtime::builder;
using symbolic::expression;

template <class System>
void expect_same_motion(const simulation<model>& interpreted, const simulation<System>& compiled,
                        double tolerance = 0) {
  ASSERT_TRUE(compiled) << compiled.cause();
  ASSERT_TRUE(interpreted) << interpreted.cause();
  ASSERT_EQ(interpreted.trajectory.size(), compiled.trajectory.size());
  for (std::size_t i = 0; i < compiled.trajectory.size(); ++i) {
    ASSERT_NEAR(interpreted.trajectory[i].t, compiled.trajectory[i].t, tolerance);
    for (int j = 0; j < compiled.state.size(); ++j)
      ASSERT_NEAR(interpreted.trajectory[i].x(j), compiled.trajectory[i].x(j), tolerance)
          << "at t = " << compiled.trajectory[i].t;
  }
  EXPECT_EQ(interpreted.statistics.steps, compiled.statistics.steps);
  EXPECT_EQ(interpreted.statistics.rate_evaluations, compiled.statistics.rate_evaluations);
}

namespace bob {

using simple_pendulum::System;
const std::initializer_list<named_value> start{{"q", 0.3}, {"u", 0}},
    numbers{{"m", 1}, {"l", 1}, {"g", 9.81}, {"c", 0.1}};

struct pendulum : built_pendulum {
  expression c = parameter("c");
  pendulum() { torque(rod, along(n, 0, 0, motor - c * u)); }
};

simulation_options<System> controlled() {
  return {.inputs = [](double, const state<System>& x, input_values<System>& r) {
    r[simple_pendulum::T] = -20 * (x[simple_pendulum::q] - 1) - 5 * x[simple_pendulum::u];
  }};
}
simulation_options<model> controlled_by_name() {
  return {.inputs = [](double, const state<model>& x, input_values<model>& r) {
    r["T"] = -20 * (x["q"] - 1) - 5 * x["u"];
  }};
}

template <integrator by>
void moves_alike() {
  const auto compiled = simulate<System, by>(start, numbers, {0, 3}, controlled());
  expect_same_motion(simulate<by>(derive<System>(), start, numbers, {0, 3}, controlled_by_name()), compiled);
  expect_same_motion(simulate<by>(pendulum(), start, numbers, {0, 3}, controlled_by_name()), compiled);
}

TEST(simulated_model, matches_the_system_to_the_last_bit_with_each_method) {
  moves_alike<integrator::adams>();
  moves_alike<integrator::bdf>();
  moves_alike<integrator::explicit_runge_kutta>();
  moves_alike<integrator::implicit_runge_kutta>();
  moves_alike<integrator::differential_algebraic>();
}

TEST(simulated_model, takes_values_by_name_as_a_map_and_as_a_vector) {
  const simulation_options<model> idle{.inputs = {{"T", 0}}};
  const std::map<std::string, double> from_a_file{{"m", 1}, {"l", 1}, {"g", 9.81}, {"c", 0.1}};
  const pendulum b;
  const auto one = simulate(b, start, numbers, {0, 1}, idle);
  const auto other =
      simulate(b, Eigen::Vector2d(0.3, 0), from_a_file, {0, 1}, {.inputs = Eigen::VectorXd::Zero(1)});
  ASSERT_TRUE(one) << one.cause();
  ASSERT_TRUE(other) << other.cause();
  EXPECT_EQ(one.state, other.state);
  EXPECT_EQ(one.state["q"], one.state(0));
  EXPECT_EQ(one.state.u()(0), one.state["u"]);
}

TEST(simulated_model, keeps_a_trajectory_like_that_of_the_system) {
  const auto compiled =
      simulate<System>(start, numbers, {0, 1}, {.inputs = {{"T", 0.2}}, .output_every = 0.1});
  pendulum b;
  model m = derive(b);
  const auto run = simulate(m, start, numbers, {0, 1}, {.inputs = {{"T", 0.2}}, .output_every = 0.1});
  expect_same_motion(run, compiled);
  input_values<model> r(m);
  r["T"] = 0.2;
  expect_same_motion(simulate(m, start, numbers, {0, 1}, {.inputs = r, .output_every = 0.1}), compiled);
  const auto& path = run.trajectory;
  const auto& reference = compiled.trajectory;
  EXPECT_EQ(path.times(), reference.times());
  EXPECT_EQ(path["q"], reference[simple_pendulum::q]);
  EXPECT_EQ(path["T"], reference[simple_pendulum::T]);
  EXPECT_TRUE(path["w"].empty());
  EXPECT_EQ(path.table().names(), reference.table().names());
  EXPECT_EQ(path.table().values(2), reference.table().values(2));
  EXPECT_EQ(path.energies().total, reference.energies().total);
  EXPECT_EQ(path.constraint_residuals(), reference.constraint_residuals());
  ASSERT_TRUE(path.at(0.45));
  EXPECT_EQ(path.at(0.45)->x, reference.at(0.45)->x);
  EXPECT_EQ(path.at(0.45)->x["q"], path.at(0.45)->x(0));
  EXPECT_FALSE(path.at(2));
  const std::vector<double> bent = path.along(b.dot(b.u));
  EXPECT_NEAR(bent[0], 0.2 - 9.81 * std::sin(0.3), 1e-14);
  EXPECT_EQ(path.along(m.mass_matrix())[3](0, 0), 1);
  pendulum other;
  EXPECT_TRUE(path.along(other.q).empty());
  EXPECT_TRUE(path.along(expression()).empty());
  EXPECT_TRUE(path.along(derive(other).mass_matrix()).empty());
}

TEST(simulated_model, rejects_a_mass_whose_expression_is_negative) {
  kanexpr::runtime::builder b("N");
  const auto n = b.inertial_frame();
  const expression x = b.coordinate("x"), v = b.speed("v"), whole = b.parameter("m"), lost = b.parameter("k");
  b.kinematic_equation(b.dot(x) - v);
  const auto at = b.offset("P", b.origin("O"), b.along(n, x, 0, 0));
  b.particle("Tank", at, whole - 2 * lost);
  const auto cause = [&](double m, double k) {
    return simulate(b, {{"x", 0}, {"v", 1}}, {{"m", m}, {"k", k}}, {0, 1}).cause();
  };
  EXPECT_EQ(cause(3, 1), "");
  EXPECT_EQ(cause(1, 1), "the mass of Tank is negative");
}

// Like masses, constants of loads are checked before the first step.
TEST(simulated_model, reports_constants_of_loads_that_make_no_sense) {
  builder b("N");
  const expression z = b.coordinate("z"), v = b.speed("v"), r = b.parameter("r"), k = b.parameter("k");
  const expression w = b.parameter("w"), T = b.parameter("T"), Tt = b.parameter("Tt");
  b.kinematic_equation(b.dot(z) - v);
  const auto n = b.inertial_frame();
  const auto o = b.origin("O"), c = b.offset("C", o, b.along(n, 0, 0, z));
  b.particle("Ball", c, b.number(1));
  runtime::contact_data data{.stiffness = k, .width = 2 * w};
  data.restitution = {0.5, w / r};
  b.point_on_plane(c, o, b.along(n, 0, 0, 1), data);
  b.lag("Filter", z, T);
  b.pid("Controller", z, 1, 1, -1, 1, Tt);
  const auto cause = [&](double at_k, double at_w, double at_T, double at_r = 1, double at_Tt = 1) {
    return simulate(b, {{"z", 1}, {"v", 0}},
                    {{"k", at_k}, {"w", at_w}, {"T", at_T}, {"r", at_r}, {"Tt", at_Tt}}, {0, 0.1})
        .cause();
  };
  EXPECT_EQ(cause(100, 0.1, 0.1), "");
  EXPECT_EQ(cause(-100, 0.1, 0.1), "parameter k, the stiffness of the contact, is not positive");
  EXPECT_EQ(cause(0, 0.1, 0.1), "parameter k, the stiffness of the contact, is not positive");
  EXPECT_EQ(cause(100, 0, 0.1), "the width of the contact is not positive");
  EXPECT_EQ(cause(100, 0.1, 0.1, -1), "the damping of the contact is negative");
  EXPECT_EQ(cause(100, 0.1, -0.1), "parameter T, the time constant of block Filter, is not positive");
  EXPECT_EQ(cause(100, 0.1, 0.1, 1, -1),
            "parameter Tt, the time constant of the integral part of block Controller, is not positive");
}

TEST(simulated_model, reports_missing_values_before_the_first_step) {
  const pendulum b;
  const simulation_options<model> idle{.inputs = {{"T", 0}}};
  const auto cause = [&](const given_state<model>& x, const given_parameters<model>& p,
                         const simulation_options<model>& o) { return simulate(b, x, p, {0, 1}, o).cause(); };
  EXPECT_EQ(cause({{"q", 0.3}}, numbers, idle), "speed u has no value");
  EXPECT_EQ(cause(start, {{"m", 1}, {"l", 1}, {"g", 9.81}}, idle), "parameter c has no value");
  EXPECT_EQ(cause(start, {{"m", -2}, {"l", 1}, {"g", 9.81}, {"c", 0}}, idle),
            "parameter m, the mass of a body, is negative");
  EXPECT_EQ(cause(start, {{"m", 1}, {"m", 1}, {"l", 1}, {"g", 9.81}, {"c", 0}}, idle),
            "parameter m has two values");
  EXPECT_EQ(cause(start, {{"mm", 1}}, idle), "the model has no parameter mm");
  EXPECT_EQ(cause({{"q", 0.3}, {"m", 0}}, numbers, idle),
            "parameter m is not an entry of the state vector of the model");
  EXPECT_EQ(cause(Eigen::Vector3d(1, 2, 3), numbers, idle),
            "the state vector of the model has 2 entries, not 3");
  EXPECT_EQ(cause({{"q", std::numeric_limits<double>::infinity()}, {"u", 0}}, numbers, idle),
            "the value of coordinate q is infinite");
  EXPECT_EQ(cause(start, numbers, {}), "input T has no value");
  EXPECT_EQ(cause(start, numbers, {.inputs = {{"S", 0}}}), "the model has no input S");
  EXPECT_EQ(cause(start, numbers, {.inputs = {{"T", 0}}, .absolute_tolerances = {{"w", 1}}}),
            "in the tolerances, the model has no coordinate or speed w");
}

TEST(simulated_model, reports_unknown_names_in_functions) {
  const pendulum b;
  const auto cause = [&](const simulation_options<model>& o) {
    return simulate(b, start, numbers, {0, 1}, o).cause();
  };
  const std::string at_start = "the simulation ended at t = 0 with q = 0.3, u = 0: ";
  EXPECT_EQ(cause({.inputs = [](double, const state<model>& x, input_values<model>& r) { r["T"] = x["w"]; }}),
            at_start + "the input function: the model has no coordinate or speed w");
  EXPECT_EQ(cause({.inputs = [](double, const state<model>&, input_values<model>& r) { r["S"] = 0; }}),
            at_start + "the input function: the model has no input S");
  EXPECT_EQ(cause({.inputs = [](double) { return input_values<model>(Eigen::Vector2d(1, 2)); }}),
            at_start + "the input function: the input vector of the model has 1 entry, not 2");
  EXPECT_EQ(cause({.inputs = [](double, const state<model>&, input_values<model>&) {}}),
            at_start + "the input function leaves input T without a finite value");
  EXPECT_EQ(
      cause({.inputs = [](double) -> input_values<model> { throw std::runtime_error("no more torque"); }}),
      at_start + "the input function threw: no more torque");
  const event<model> odd(
      "odd", [](double, const auto&, const parameter_values<model>& p, const auto&) { return p["k"]; });
  EXPECT_THAT(cause({.inputs = {{"T", 0}}, .events = {odd}}),
              testing::HasSubstr("the event odd: the model has no parameter k"));
}

TEST(simulated_model, reports_the_mistake_of_its_model) {
  pendulum b;
  b.speed("q");
  const auto run = simulate(b, start, numbers, {0, 1});
  EXPECT_EQ(run.cause(), "the name q is used twice");
  EXPECT_TRUE(run.trajectory.empty());
  EXPECT_TRUE(run.trajectory.energies().total.empty());
}

TEST(simulated_model, moves_after_a_rejected_request) {
  model m = derive<System>();
  EXPECT_EQ(m.get<speed<"w">{} * simple_pendulum::u>().entries.size(), 0);
  EXPECT_NE(m.mistake(), "");
  EXPECT_TRUE(simulate(m, start, numbers, {0, 1}, {.inputs = {{"T", 0}}}));
}

TEST(simulated_model, begins_with_the_inputs_of_a_function_of_time) {
  const auto compiled = simulate<System>(start, numbers, {0, 2}, {.inputs = [](double t) {
                                           input_values<System> r;
                                           r[simple_pendulum::T] = std::sin(t);
                                           return r;
                                         }});
  model m = derive<System>();
  const auto run = simulate(m, start, numbers, {0, 2}, {.inputs = [m](double t) {
                              input_values<model> r(m);
                              r["T"] = std::sin(t);
                              return r;
                            }});
  expect_same_motion(run, compiled);
}

} // namespace bob

TEST(simulated_model, bounces_like_the_system) {
  using namespace falling_ball;
  const std::initializer_list<named_value> start{{"h", 2}, {"v", 0}}, numbers{{"m", 0.3}, {"g", 9.81}};
  const event<System> stop(
      "late", [](double t, const auto&, const auto&, const auto&) { return t - 2.5; }, crossing::rising,
      after_event::stop);
  const auto compiled = simulate<System>(
      start, numbers, {0, 3},
      {.dense = true,
       .events = {when<System, dot(position_of<P, O>, N::z)>(
                      "contact", crossing::falling, [](moment<System>& now) { now.x[v] = -0.8 * now.x[v]; }),
                  stop}});

  builder b("N");
  const auto height = b.coordinate("h"), rate = b.speed("v"), mass = b.parameter("m"), g = b.parameter("g");
  b.kinematic_equation(b.dot(height) - rate);
  const auto ground = b.inertial_frame();
  b.particle("Ball", b.offset("P", b.origin("O"), b.along(ground, b.number(0.0), b.number(0.0), height)),
             mass);
  b.gravity(b.along(ground, b.number(0.0), b.number(0.0), -g));
  model ball = derive(b);
  const auto run = simulate(
      ball, start, numbers, {0, 3},
      {.dense = true,
       .events = {when(ball, height, "contact", crossing::falling,
                       [](moment<model>& now) { now.x["v"] = -0.8 * now.x["v"]; }),
                  event<model>(
                      "late", [](double t, const auto&, const auto&, const auto&) { return t - 2.5; },
                      crossing::rising, after_event::stop)}});
  expect_same_motion(run, compiled);
  EXPECT_TRUE(run.stopped_by_event);
  ASSERT_EQ(run.events.size(), 4u);
  for (std::size_t i = 0; i < run.events.size(); ++i) {
    EXPECT_EQ(run.events[i].t, compiled.events[i].t);
    EXPECT_EQ(run.events[i].name, compiled.events[i].name);
  }
  EXPECT_EQ(run.trajectory.at(1.3)->x, compiled.trajectory.at(1.3)->x);
  builder other("N");
  EXPECT_EQ(simulate(ball, start, numbers, {0, 3}, {.events = {when(ball, other.time(), "odd")}}).cause(),
            "the event odd has no function");
}

TEST(simulated_model, follows_a_prescribed_quantity) {
  using namespace rotating_tube;
  const std::initializer_list<named_value> start{{"q", 0.4}, {"u", 0}};
  const std::initializer_list<named_value> numbers{
      {"m", 0.2}, {"k", 30}, {"q0", 0.4}, {"g", 9.81}, {"c", 0.3}};
  const auto angle = [](auto t) {
    using std::sin;
    return 0.5 * sin(3 * t);
  };
  const auto compiled = simulate<System>(
      start, numbers, {0, 2}, {.inputs = [&](double t, const state<System>&, input_values<System>& r) {
        prescribe(r, theta, t, angle);
      }});
  const auto run = simulate(derive<System>(), start, numbers, {0, 2},
                            {.inputs = [&](double t, const state<model>&, input_values<model>& r) {
                              prescribe(r, "theta", t, angle);
                            }});
  expect_same_motion(run, compiled);

  const auto cause = [&](const input_source<model>& inputs) {
    return simulate(derive<System>(), start, numbers, {0, 2}, {.inputs = inputs}).cause();
  };
  EXPECT_EQ(cause({{"theta", 0}, {"theta'", 2}, {"theta''", 0}}),
            "prescribed quantity theta is constant, but its rate is given as 2");
  EXPECT_EQ(cause([](double t, const state<model>&, input_values<model>& r) {
              r["theta"] = t * t, r["theta'"] = 2 * t, r["theta''"] = -2;
            }),
            "prescribed quantity dot(theta) changes at the rate 2 at t = 0.002, but its rate is given as -2");
}

TEST(simulated_model, rejects_an_impossible_inertia) {
  kanexpr::runtime::builder b("N");
  const expression q = b.coordinate("q"), u = b.speed("u"), across = b.parameter("J"), m = b.parameter("m");
  b.kinematic_equation(b.dot(q) - u);
  const auto a = b.rotated("A", b.inertial_frame(), q, b.along(b.inertial_frame(), 0, 0, 1));
  b.rigid_body("Rod", b.origin("O"), a, m, b.inertia(a, 1, 1, 2, across, 0.0, 0.0));
  const auto cause = [&](double j) {
    return simulate(b, {{"q", 0}, {"u", 1}}, {{"J", j}, {"m", 1}}, {0, 1}).cause();
  };
  EXPECT_EQ(cause(0.001), "");
  EXPECT_EQ(cause(-3), "the inertia of Rod is indefinite: its moment about some axis is negative");
}

namespace linkage {

using four_bar::System;
const std::map<std::string, double> numbers{{"l0", 2},   {"l1", 0.7}, {"l2", 1.8}, {"l3", 1.2}, {"d1", 0.5},
                                            {"d2", 0.5}, {"d3", 0.5}, {"m1", 0.5}, {"m2", 0.5}, {"m3", 0.5},
                                            {"I1", 0.5}, {"I2", 0.5}, {"I3", 0.5}, {"g", 9.81}};
const std::initializer_list<named_value> start{{"q1", 0.6}, {"q2", 0.3}, {"q3", -1.7}, {"u1", 1.4}};

// The same four-bar linkage with the same choice of dependent coordinates and speeds.
struct built : builder {
  built() : builder("N") {
    const expression q[]{coordinate("q1"), coordinate("q2"), coordinate("q3")};
    const expression u[]{speed("u1"), speed("u2"), speed("u3")};
    for (int i = 0; i < 3; ++i) kinematic_equation(dot(q[i]) - u[i]);
    const auto numbered = [&](const char* called) {
      const std::string name = called;
      return std::array{parameter(name + "1"), parameter(name + "2"), parameter(name + "3")};
    };
    const auto ground_length = parameter("l0");
    const auto l = numbered("l"), d = numbered("d"), m = numbered("m"), i = numbered("I");
    const auto g = parameter("g"), motor = input("T"), zero = number(0.0);
    const auto ground = inertial_frame();
    const char* const bars[]{"A", "B", "C"};
    const char *const ends[]{"P1", "P2", "P3"}, *const centers[]{"G1", "G2", "G3"};
    auto frame = ground;
    const auto o = origin("O"), bearing = offset("Bearing", o, along(ground, ground_length, zero, zero));
    auto joint = o;
    for (std::size_t k = 0; k < 3; ++k) {
      frame = rotated(bars[k], frame, q[k], along(frame, 0, 0, 1));
      if (k == 0) torque(frame, along(ground, zero, zero, motor));
      rigid_body(bars[k], offset(centers[k], joint, along(frame, d[k], zero, zero)), frame, m[k],
                 inertia(frame, zero, zero, i[k]));
      joint = offset(ends[k], joint, along(frame, l[k], zero, zero));
    }
    gravity(along(ground, zero, -g, zero));
    configuration_constraint(
        builder::zero_along(position_of(joint, bearing), along(ground, 1, 0, 0), along(ground, 0, 1, 0)));
    for (const expression& e : {q[1], q[2], u[1], u[2]}) dependent(e);
  }
};

template <integrator by>
void moves_alike() {
  const auto compiled = simulate<System, by>(
      start, numbers, {0, 2}, {.inputs = {{"T", 0.3}}, .guesses_dependent = true, .output_every = 0.1});
  const simulation_options<model> driven{
      .inputs = {{"T", 0.3}}, .guesses_dependent = true, .output_every = 0.1};
  const auto run = simulate<by>(derive<System>(), start, numbers, {0, 2}, driven);
  expect_same_motion(run, compiled);
  expect_same_motion(simulate<by>(built(), start, numbers, {0, 2}, driven), compiled, 1e-12);
  EXPECT_EQ(run.trajectory.constraint_residuals(), compiled.trajectory.constraint_residuals());
  EXPECT_LT(std::ranges::max(run.trajectory.constraint_residuals()), 1e-8);
}

TEST(simulated_model, keeps_a_four_bar_linkage_closed_like_the_system) {
  moves_alike<integrator::adams>();
  moves_alike<integrator::bdf>();
  moves_alike<integrator::explicit_runge_kutta>();
  moves_alike<integrator::implicit_runge_kutta>();
  moves_alike<integrator::differential_algebraic>();
}

TEST(simulated_model, rejects_inconsistent_dependent_values) {
  EXPECT_THAT(simulate(built(), start, numbers, {0, 2}, {.inputs = {{"T", 0}}}).cause(),
              testing::StartsWith(
                  "coordinate q2, which is dependent, was given as 0.3, but the constraints require -0.146"));
}

TEST(simulated_model, cannot_begin_if_its_bars_do_not_meet) {
  std::map<std::string, double> apart = numbers;
  apart["l0"] = 9;
  const auto run = simulate(built(), start, apart, {0, 2}, {.inputs = {{"T", 0}}});
  EXPECT_THAT(run.cause(), testing::HasSubstr("the search for the dependent coordinates"));
}

} // namespace linkage

// Two examples of the Modelica Standard Library, at times for which the Modelica Association publishes
// reference results (MAP-LIB_ReferenceResults, commit d6a2b9b2).
namespace published {

/// Rotors on one axis, whose angles are q0, q1, ….
struct rotors : builder {
  std::vector<expression> q, u;

  rotors(int count, double inertia_of_each) : builder("N") {
    for (int i = 0; i < count; ++i) {
      q.push_back(coordinate("q" + std::to_string(i)));
      u.push_back(speed("u" + std::to_string(i)));
      kinematic_equation(dot(q.back()) - u.back());
    }
    const auto n = inertial_frame();
    const auto o = origin("O");
    for (std::size_t i = 0; i < q.size(); ++i) {
      const std::string name = "R" + std::to_string(i);
      const auto frame = rotated(name, n, q[i], along(n, 0, 0, 1));
      const auto place = offset("P" + name, o, along(n, 0, 0, static_cast<double>(i)));
      rigid_body("Body" + name, place, frame, number(1),
                 inertia(frame, inertia_of_each, inertia_of_each, inertia_of_each));
    }
  }
};

// Modelica.Electrical.Machines.Examples.DCMachines.DCPM_Start: from 0.2 s to 1 s, the voltage of a motor
// rises to 100 V; from 1.5 s on, its nominal load acts. The torque constant follows from 100 V and 100 A at
// 1425 turns a minute.
TEST(published_motion, of_a_motor_that_starts_and_is_loaded) {
  rotors b(1, 0.3);
  const double speed = 1425 * std::numbers::pi / 30;
  const expression from = b.parameter("V0"), rate = b.parameter("k"), load = b.parameter("T");
  const expression voltage = from + rate * b.time();
  const auto motor = b.dc_motor(
      "M", b.u[0],
      {.voltage = voltage, .resistance = 0.05, .inductance = 0.0015, .torque_constant = 95 / speed});
  const auto n = b.inertial_frame();
  b.torque(runtime::frame_id{1}, b.along(n, 0, 0, motor.torque - load));
  const model m = derive(b);
  ASSERT_EQ(model(m).mistake(), "");
  const simulation_options<model> exactly{.relative_tolerance = 1e-10, .absolute_tolerance = 1e-10};
  // the time, and then the angle, the speed and the current
  const std::vector<std::array<double, 4>> expected{
      {0.4, 2.5152015836659438, 32.177592111589469, 93.737525294019832},
      {0.6, 12.851956218083691, 71.266903594703308, 92.669134759459354},
      {1.0, 57.069126266998637, 149.81253747245447, 92.527382097325514},
      {1.2, 88.443422413123088, 156.90485422894133, -1.2099828240617085},
      {1.5, 135.55801015665432, 157.07782899504812, 0.020852917493725073},
      {1.6, 150.5755357538157, 147.67128359238836, 107.48639057541895},
      {1.8, 180.38243838329311, 149.2243851183714, 99.335323121834094},
      {2.0, 210.22598365106813, 149.22784527717297, 99.974346641065665}};
  Eigen::VectorXd x = Eigen::VectorXd::Zero(3);
  double t = 0.2;
  for (const auto& row : expected) {
    const double slope = t < 1 ? 125 : 0, base = t < 1 ? -25 : 100, torque = t < 1.5 ? 0 : 63.66;
    const auto run = simulate(m, x, {{"V0", base}, {"k", slope}, {"T", torque}}, {t, row[0]}, exactly);
    ASSERT_TRUE(run) << run.cause();
    t = row[0], x = run.state;
    for (int i = 0; i < 3; ++i)
      EXPECT_NEAR(x(i), row[static_cast<std::size_t>(i) + 1], 1e-4) << i << " at " << t;
  }
}

// Modelica.Mechanics.Rotational.Examples.CoupledClutches until the first clutch breaks away from its
// stiction, which smooth friction does not have: four rotors, of which the first one turns and is driven, and
// three clutches, of which the second one closes after 0.4 s and the third one does not close.
TEST(published_motion, of_coupled_clutches) {
  rotors b(4, 1);
  const auto n = b.inertial_frame();
  const expression turning = 10 * std::numbers::pi * b.time(), closing = 0.4 * std::numbers::pi * b.time();
  b.torque(runtime::frame_id{1}, b.along(n, 0, 0, 10 * sin(turning)));
  const mechanics::friction_law law = mechanics::friction_law::coulomb(b.number(0.5), b.number(1e-5));
  const expression first = 20 * cos(closing), second = 20 * b.parameter("closed");
  b.friction_along(b.given_length(b.q[0] - b.q[1]), first, law);
  b.friction_along(b.given_length(b.q[1] - b.q[2]), second, law);
  const model m = derive(b);
  ASSERT_EQ(model(m).mistake(), "");
  // the time, the angle and the speed of the first rotor, and the speeds of the next two relative to the one
  // before
  const std::vector<std::array<double, 5>> expected{
      {0.2, 1.8647093390017737, 8.0209635791052225, -6.0419523375344308, -1.9790112415707943},
      {0.4, 3.3440205459395576, 6.1663000830969734, -2.3326261541955158, -3.833673928901459},
      {0.5, 3.9497347165554051, 5.9591172373381083, -2.281670967462555, -2.6774462698755555},
      {0.6, 4.4746468022120984, 4.5524868724857184, -1.1050342370975506, -1.4474526353881585},
      {0.7, 4.9267596443423969, 4.5050142580219736, -1.3734648417495323, -0.13154941627241934},
      {0.8, 5.3154432093114572, 3.3333219642262319, 0, 0}};
  Eigen::VectorXd x = Eigen::VectorXd::Zero(8);
  x(4) = 10;
  double t = 0;
  for (const auto& row : expected) {
    const auto run = simulate<integrator::bdf>(
        m, x, {{"closed", t < 0.4 ? 0.0 : 1.0}}, {t, row[0]},
        {.relative_tolerance = 1e-9, .absolute_tolerance = 1e-10, .most_steps = 100'000});
    ASSERT_TRUE(run) << run.cause();
    t = row[0], x = run.state;
    const double found[]{x(0), x(4), x(5) - x(4), x(6) - x(5)};
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(found[i], row[i + 1], 1e-4) << i << " at " << t;
  }
}

} // namespace published

} // namespace
