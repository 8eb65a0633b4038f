#pragma once

#include <kanexpr/ensemble/runnable.hpp>
#include <kanexpr/ensemble/stepped_study.hpp>

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
class ensemble_in_steps : public ensembles::runnable<ensembles::stepped_study<Step, Law, Number>> {
public:
  explicit ensemble_in_steps(study_in_steps<Step, Number> told, Law law = {})
      : ensembles::runnable<ensembles::stepped_study<Step, Law, Number>>(std::in_place, std::move(told),
                                                                         std::move(law)) {}
};

} // namespace kanexpr
