#pragma once

#include <kanexpr/ensemble/run_study.hpp>
#include <kanexpr/ensemble/simulated_study.hpp>

#include <memory>
#include <utility>

namespace kanexpr {

/// Many simulations of one system, which share out the cores of the machine:
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
/// What is found does not depend on the number of threads, to the last bit. A run that fails is a row like
/// the others, with its cause among the `failures`, and the study goes on. Another method of integration is
/// named as in `ensemble<System, integrator::bdf>`.
template <class System, integrator by = integrator::adams>
class ensemble {
public:
  explicit ensemble(study<System> told)
      : job_(std::make_shared<ensembles::simulated_study<System, by>>(std::move(told))) {
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
  std::shared_ptr<const ensembles::simulated_study<System, by>> job_;
};

} // namespace kanexpr
