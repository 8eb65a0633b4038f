#pragma once

#include <kanexpr/compiled/equations_of_motion.hpp>
#include <kanexpr/compiled/out_of_line.hpp>
#include <kanexpr/compiled/survey_of.hpp>
#include <kanexpr/mechanics/quantity.hpp>
#include <kanexpr/numeric/independence.hpp>

#include <type_traits>

namespace kanexpr {

/// Checks whether the velocity constraints are independent at a state. If not, for example when all bars of a
/// linkage are in line, the report lists the constraints that follow from the preceding ones, as rows of
/// `constraint_jacobian`.
template <class System, class Number = double, class Parameters = parameter_values<System, Number>,
          class Inputs = input_values<System, Number>>
independence check_independence(const state<System, Number>& x, const Parameters& p = {},
                                const Inputs& r = {}, std::type_identity_t<Number> t = 0) {
  using jacobian = out_of_line<
      function<System, mechanics::quantity::velocity_residual, mechanics::quantity::constraint_jacobian>>;
  if constexpr (compiled::survey_of<System>.constraints == 0)
    return {};
  else
    return numeric::independence_of(std::get<1>(jacobian{}(t, x, p, r)).template cast<double>());
}

} // namespace kanexpr
