// builds: clang++ all
// The contents of studies, their identities and mistakes.
#include "ensembles/turning.hpp"

#include <kanexpr/ensembles/collector.ipp>

#include <gmock/gmock.h>

#include <cmath>
#include <stdexcept>
#include <string>

namespace {

using namespace simple_pendulum;

template <class Runner>
std::string identity_of(study_of<typename Runner::kind> study) {
  return ensembles::identity_of(ensembles::study_runs<Runner>(std::move(study), Runner()));
}

// Two versions of a model with the same symbols; the first is equal to the model itself.
namespace before {
struct System
    : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, parameters<m, l, g, c>,
                  inputs<T>, bodies<Bob>, loads<gravity<g * N::x>, torque<A, (T - c * u) * N::z>>> {};
} // namespace before
namespace after {
struct System
    : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, parameters<m, l, g, c>,
                  inputs<T>, bodies<Bob>, loads<gravity<g * N::x>, torque<A, (T - 2 * c * u) * N::z>>> {};
} // namespace after

TEST(study, begins_functions_anew_with_every_run) {
  study<System> told = turning({{u, evenly_spaced(0.1, 0.2, 200)}});
  told.state = {{q, 0}};
  told.span = {0, 1};
  told.for_each_run = [calls = 0](const run_values&, simulation_setup<System>& one) mutable {
    one.x[q] = ++calls;
  };
  told.inputs = {};
  told.simulation.inputs = [begun = false](double, const state<System>& x) mutable {
    const bool is_first = !begun;
    begun = true;
    return input_values<System>{{T, is_first && x[q] > 1.5 ? 1e6 : 0}};
  };
  told.keep = {at_end<q>()};
  const auto found = ensemble<System>(told).run({.threads = 4});
  ASSERT_TRUE(found) << found.cause();
  for (std::size_t i = 0; i < 200; ++i) EXPECT_NEAR(found.runs["q_end"][i], 1 + found.runs["u"][i], 1e-6);
}

TEST(study, is_another_where_anything_of_it_differs) {
  const auto text = [](const study<System>& told) {
    return identity_of<ensembles::simulation_runner<System, integrator::adams>>(told);
  };
  study<System> told = turning({{u, {1}}});
  told.state = {{q, 0}};
  told.keep = {at_end<q>("kept")};
  const std::string first = text(told);
  EXPECT_EQ(text(told), first);
  const auto expect_other = [&](auto change) {
    study<System> other = told;
    change(other);
    EXPECT_NE(text(other), first);
  };
  expect_other([](auto& s) { s.keep = {greatest<q>("kept")}; });
  expect_other([](auto& s) { s.keep = {at_end<u>("kept")}; });
  expect_other([](auto& s) { s.simulation.absolute_tolerance = 1e-9; });
  expect_other([](auto& s) { s.simulation.absolute_tolerances = {{q, 1e-9}}; });
  expect_other([](auto& s) { s.simulation.greatest_step = 0.1; });
  expect_other([](auto& s) { s.simulation.output_every = 0.1; });
  expect_other([](auto& s) { s.simulation.most_steps = 100; });
  expect_other([](auto& s) { s.simulation.events = {when<System, q>("passes")}; });
  expect_other([](auto& s) { s.simulation.dense = true; });
  expect_other([](auto& s) { s.simulation.guesses_dependent = true; });
  expect_other([](auto& s) { s.simulation.each_sample = [](const sample<System>&) {}; });
  expect_other([](auto& s) { s.inputs = {{T, std::nextafter(0, 1)}}; });
  expect_other([](auto& s) { s.inputs = {}, s.simulation.inputs = {{T, 1}}; });
  expect_other([](auto& s) { s.for_each_run = [](const run_values&, auto&) {}; });
  EXPECT_NE((identity_of<ensembles::simulation_runner<System, integrator::bdf>>(told)), first);
}

TEST(study, is_another_with_another_event_of_the_same_name) {
  const auto text = [](event<System> passes, run_output<System> kept) {
    study<System> told = turning({{u, {1}}});
    told.state = {{q, 0}};
    told.simulation.events = {std::move(passes), when < System, q == 3 > ("turns")};
    told.keep = {std::move(kept)};
    return identity_of<ensembles::simulation_runner<System, integrator::adams>>(told);
  };
  const auto passes = first_time_of("passes", "t");
  const std::string first = text(when<System, q>("passes"), passes);
  EXPECT_EQ(text(when<System, q>("passes"), passes), first);
  EXPECT_NE(text(when<System, u>("passes"), passes), first);
  EXPECT_NE(text(when<System, 2 * q>("passes"), passes), first);
  EXPECT_NE(text(when<System, q>("passes", crossing::rising), passes), first);
  EXPECT_NE(text(when<System, q>("passes", crossing::either, after_event::stop), passes), first);
  const auto handled = [&](event_handler<System> act) {
    return text(when<System, q>("passes", crossing::either, std::move(act)), passes);
  };
  EXPECT_NE(handled(after_event::stop), handled(after_event::go_on));
  EXPECT_NE(handled(after_event::stop), handled([](auto&) { return after_event::stop; }));
  EXPECT_NE(text({"passes", [](double, const auto& x, const auto&, const auto&) { return x[q]; }}, passes),
            first);
  EXPECT_NE(text(when<System, q>("passes"), first_time_of("turns", "t")), first);
  EXPECT_NE(text(when<System, q>("passes"), last_time_of("passes", "t")), first);
}

TEST(study, is_another_of_another_model_alone) {
  const auto text = []<class Model>(Model) {
    return identity_of<ensembles::simulation_runner<Model, integrator::adams>>(
        {.runs = grid({{q, {1, 2}}}),
         .state = {{u, 0}},
         .parameters = {{m, 1}, {l, 1}, {g, 9.81}},
         .span = {0, 1},
         .simulation = {.events = {when<Model, q>("passes")}},
         .keep = {at_end<q>(), greatest<u>()}});
  };
  const std::string first = text(System());
  EXPECT_EQ(text(before::System()), first);
  EXPECT_NE(text(after::System()), first);
  // The identity of a study in steps contains the name of the step, which contains the namespace of the
  // system.
  EXPECT_EQ(compiled::digest_of_model<System>, compiled::digest_of_model<before::System>);
  EXPECT_NE(compiled::digest_of_model<System>, compiled::digest_of_model<after::System>);
}

TEST(study, in_steps_is_another_where_anything_of_it_differs) {
  using told_study = study_in_steps<runge_kutta_4<System>>;
  const auto text = [](const told_study& told) {
    return identity_of<ensembles::step_runner<runge_kutta_4<System>, ensembles::constant_inputs, double>>(
        told);
  };
  const told_study told{
      .runs = grid({{q, {1, 2}}}), .span = {.step = 0.1, .steps = 10}, .keep = {at_end<q>("kept")}};
  const std::string first = text(told);
  EXPECT_NE(
      first.find(std::string_view(reinterpret_cast<const char*>(&compiled::digest_of_model<System>), 8)),
      std::string::npos);
  const auto expect_other = [&](auto change) {
    told_study other = told;
    change(other);
    EXPECT_NE(text(other), first);
  };
  expect_other([](auto& s) { s.keep = {at_end<u>("kept")}; });
  expect_other([](auto& s) { s.keep = {least<q>("kept")}; });
  expect_other([](auto& s) { s.span.step = 0.2; });
  expect_other([](auto& s) { s.simulation.guesses_dependent = true; });
  expect_other([](auto& s) { s.for_each_run = [](const run_values&, auto&) {}; });
  EXPECT_NE(
      (identity_of<ensembles::step_runner<semi_implicit_euler<System>, ensembles::constant_inputs, double>>(
          {.runs = told.runs, .span = {.step = 0.1, .steps = 10}, .keep = {at_end<q>("kept")}})),
      first);
}

TEST(study, says_what_of_it_cannot_be) {
  const auto refusal = [](const study<System>& told) { return ensemble<System>(told).run().cause(); };
  study<System> told = turning({{factor{"g"}, {1}}, {u, {1}}});
  told.state = {{q, 0}};
  EXPECT_EQ(refusal(told), "the factor g has the name of a symbol of the system System");
  told.runs = grid({{u, {1}}});
  told.keep_events = true;
  EXPECT_EQ(refusal(told), "the study has no events to keep");
  told.keep_events = false;
  told.runs = random_runs(
      3, {{u, distribution("none", [](double) -> double { throw std::runtime_error("no number"); })}}, 1);
  EXPECT_EQ(refusal(told), "no number");
  told.runs = random_runs(3,
                          {{u, distribution("some",
                                            [](double part) {
                                              if (part > 0.5) throw std::runtime_error("no number");
                                              return part;
                                            })}},
                          5);
  const auto found = ensemble<System>(told).run();
  EXPECT_TRUE(found.failed > 0 || found.cause() == "no number");
  told.runs = grid({{u, {1, 2}}});
  told.for_each_run = [](const run_values&, auto&) {};
  told.keep = {times_of("flip", "flips")};
  EXPECT_EQ(refusal(told),
            "all 2 runs failed, the first of them: the simulations of the study have no event flip");
}

TEST(study, in_steps_survives_a_law_that_throws) {
  study_in_steps<runge_kutta_4<System>> told{.runs = grid({{u, evenly_spaced(0.5, 1.5, 9)}}),
                                             .state = {{q, 0}},
                                             .parameters = {{m, 1}, {l, 1}, {g, 0}, {c, 0}},
                                             .span = {.step = 0.1, .steps = 10}};
  const auto law = [](double, const state<System>& x) {
    if (x[q] > 1.25) throw std::runtime_error("too far");
    return input_values<System>{{T, 0}};
  };
  const auto found = ensemble_in_steps(told, law).run({.threads = 1});
  ASSERT_TRUE(found) << found.cause();
  EXPECT_GT(found.failed, 0u);
  EXPECT_EQ(found.failures.back().run, 8u);
  EXPECT_EQ(found.failures.back().cause, "too far");
}

} // namespace
