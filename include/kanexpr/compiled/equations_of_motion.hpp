#pragma once

#include <kanexpr/compiled/function.hpp>
#include <kanexpr/compiled/named_results.hpp>
#include <kanexpr/compiled/survey_of.hpp>
#include <kanexpr/derivation/request_kinds.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

namespace kanexpr {

/// The equations of motion of a system as compiled functions: `equations_of_motion<System>::mass_matrix(x,
/// p)`. The functions accept the state x, the parameters p, the inputs r and, if a result depends on them,
/// rates of the speeds a; the time t precedes x if the system depends on it. `mechanics::quantity` lists the
/// shapes of all results. Numbers carry no units; results have those of the model.
template <class System>
struct equations_of_motion : compiled::named_results<function, System> {
  using with_respect_to = derivation::with_respect_to;
  /// The derivatives of a result, with its entries in row-major order, with respect to all entries of the
  /// state as if they were unconstrained: `eom::derivatives<eom::quantity::inverse_dynamics>(x, p, r, a)`.
  /// The second template argument selects the inputs, or the rates of the speeds passed to the result, in
  /// place of the state: `eom::derivatives<…, eom::with_respect_to::rates>`.
  template <mechanics::quantity of, with_respect_to symbols = with_respect_to::state>
  static constexpr function<System, derivation::derivatives_of_result{of, symbols}> derivatives{};

  /// Evaluates several results in one call, which computes common subexpressions only once: `auto [M, f] =
  /// together(mass_matrix, forcing)(x, p);`
  template <auto... first, auto... second, class... More>
  static constexpr auto together(function<System, first...>, function<System, second...>, More... more) {
    if constexpr (sizeof...(More) == 0)
      return function<System, first..., second...>{};
    else
      return together(function<System, first..., second...>{}, more...);
  }

  /// Returns the number of operations of one call of a function:
  /// `static_assert(eom::cost(eom::mass_matrix).multiplications <= 10);`
  template <auto... wanted>
  static constexpr symbolic::cost cost(function<System, wanted...> f) {
    return f.cost();
  }
};

} // namespace kanexpr
