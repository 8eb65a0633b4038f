#pragma once

#include <kanexpr/ensembles/run_on_threads.hpp>
#include <kanexpr/ensembles/simulation_runner.hpp>
#include <kanexpr/ensembles/step_runner.hpp>
#include <kanexpr/ensembles/study_runs.hpp>

#include <memory>
#include <utility>

namespace kanexpr {

/// A study that can be run any number of times. Copies share the study.
template <class Runner>
class ensemble_of {
public:
  explicit ensemble_of(study_of<typename Runner::kind> what, Runner runner = Runner())
      : runs_(std::make_shared<ensembles::study_runs<Runner>>(std::move(what), std::move(runner))) {}

  ensemble_results run(const ensemble_options& options = {}) const {
    return unless_mistaken([&] { return ensembles::run_on_threads(*runs_, options); });
  }
  /// Runs the study on MPI ranks (<kanexpr/mpi.hpp>).
  template <class Ranks>
  ensemble_results run(const ensemble_options& options, Ranks& ranks) const {
    return unless_mistaken([&] { return ranks.run(*runs_, options); });
  }

  const study_layout& layout() const { return runs_->layout(); }

private:
  template <class Run>
  ensemble_results unless_mistaken(const Run& run) const {
    if (runs_->mistake().empty()) return run();
    ensemble_results none;
    none.planned = layout().runs;
    none.failure = runs_->mistake();
    return none;
  }

  std::shared_ptr<const ensembles::study_runs<Runner>> runs_;
};

/// Many simulations of one system, on all cores of the machine:
///
///     const ensemble<System> pendulums({
///         .runs = latin_hypercube(1000, {{q, uniform(-3, 3)}, {m, normal(1, 0.1)}}, 42),
///         .state = {{u, 0}},
///         .parameters = {{l, 1}, {g, 9.81}},
///         .span = {0, 10},
///         .keep = {at_end<q>(), greatest<u>("fastest", "rad/s")},
///     });
///     const ensemble_results found = pendulums.run({.progress = progress_bar()});
///     if (!found) std::cerr << found.cause() << '\n';
///     for (double angle : found.runs["q"]) …
///
/// The results are the same to the last bit for any number of threads. A run that fails has a row like the
/// others and its cause in `failures`, and the study continues. Select a different integrator as in
/// `ensemble<System, integrator::bdf>`.
template <class System, integrator by = integrator::adams>
using ensemble = ensemble_of<ensembles::simulation_runner<System, by>>;

/// Simulates many runs of one system with steps of fixed length, several per SIMD vector:
///
///     const auto pendulums = ensemble_in_steps<runge_kutta_4<System>>({
///         .runs = grid({{q, evenly_spaced(-3, 3, 1000)}}),
///         .state = {{u, 0}},
///         .parameters = {{m, 1}, {l, 1}, {g, 9.81}},
///         .span = {.step = 1e-3, .steps = 10'000},
///         .keep = {at_end<q>("q_end"), greatest<u>("fastest")},
///     });
///
/// Inputs are constants by name, or a function (t, x): `ensemble_in_steps(study, law)`. The function takes
/// one state, or a batch of states if its second parameter is `const auto&`.
template <class Step, class Law = ensembles::constant_inputs, class Number = double>
auto ensemble_in_steps(study_in_steps<Step, Number> what, Law law = {}) {
  using runner = ensembles::step_runner<Step, Law, Number>;
  return ensemble_of<runner>(std::move(what), runner(std::move(law)));
}

} // namespace kanexpr
