#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/status.hpp>
#include <kanexpr/compiled/not_finite.hpp>
#include <kanexpr/compiled/state.hpp>
#include <kanexpr/compiled/survey_of.hpp>
#include <kanexpr/numeric/least_multipliers.hpp>
#include <kanexpr/steps/unreduced_equations.hpp>

#include <type_traits>

namespace kanexpr {

/// Returns u̇ and the multipliers at a state where constraints may be linearly dependent: redundant
/// constraints, or any constraints at a singular position. u̇ is the acceleration that Gauss's principle
/// gives under the constraints at this state; at a bifurcation of a mechanism, the constraints do not
/// determine which branch the motion takes. If the multipliers are not unique, those with the least sum of
/// squares, each in its unit, are returned.
template <class System, class Number = double, class Parameters = parameter_values<System, Number>,
          class Inputs = input_values<System, Number>>
auto find_least_multipliers(const state<System, Number>& x, const Parameters& p = {}, const Inputs& r = {},
                            std::type_identity_t<Number> t = 0) {
  using equations = steps::unreduced_equations<System, Number, Parameters, const Inputs&,
                                               steps::unreduced_rows::all_velocities>;
  using vector = typename numeric::constrained_motion<equations>::state;
  auto found =
      numeric::find_least_multipliers(equations(t, p, r), vector(x), compiled::survey_of<System>.constraints);
  if (!found)
    found.failure = base::sentence(
        {compiled::not_finite<System>::cause_of(status(found.failure.view()), x, p, r).view()});
  return found;
}

} // namespace kanexpr
