#pragma once

#include <kanexpr/ensemble/runnable.hpp>
#include <kanexpr/ensemble/simulated_study.hpp>

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
class ensemble : public ensembles::runnable<ensembles::simulated_study<System, by>> {
public:
  explicit ensemble(study<System> told)
      : ensembles::runnable<ensembles::simulated_study<System, by>>(std::in_place, std::move(told)) {}
};

} // namespace kanexpr
