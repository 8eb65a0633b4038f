#pragma once

#include <kanexpr/ensemble/run_study.hpp>
#include <kanexpr/ensemble/stepped_study.hpp>

#include <memory>
#include <utility>

namespace kanexpr {

/// Many motions of one system in steps of a fixed length, side by side in the vectors of the processor and on
/// the cores of the machine:
///
///     const ensemble_in_steps<runge_kutta_4<System>> pendulums({
///         .runs = grid({{q, evenly_spaced(-3, 3, 1000)}}),
///         .state = {{u, 0}},
///         .parameters = {{m, 1}, {l, 1}, {g, 9.81}},
///         .step = 1e-3,
///         .steps = 10'000,
///         .keep = {at_end<q>("q_end"), greatest<u>("fastest")},
///     });
///
/// The inputs are constants, by name, or a function (t, x), the second argument: of a batch of states where x
/// may be of any type, else of one state after another; then it is `ensemble_in_steps study(told, law)`.
/// There are no events, and extremes are those of the states that are looked at. Of a `study_in_steps<Step,
/// float>` twice as many go side by side.
template <class Step, class Law = ensembles::constant_inputs, class Number = double>
class ensemble_in_steps {
public:
  explicit ensemble_in_steps(study_in_steps<Step, Number> told, Law law = {})
      : job_(std::make_shared<ensembles::stepped_study<Step, Law, Number>>(std::move(told), std::move(law))) {
    job_->itself = job_;
  }

  ensemble_results run(const ensemble_options& options = {}) const {
    ensembles::on_threads threads;
    return run(options, threads);
  }
  /// The same by others than threads of this process, as the ranks of <kanexpr/mpi.hpp>.
  ensemble_results run(const ensemble_options& options, ensembles::crew& who) const {
    return ensembles::run_study(*job_, options, who);
  }

  const study_layout& layout() const { return job_->layout(); }

private:
  std::shared_ptr<const ensembles::stepped_study<Step, Law, Number>> job_;
};

} // namespace kanexpr
