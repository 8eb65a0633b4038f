#pragma once

#include <kanexpr/base/status.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/lower/complex_math.hpp>
#include <kanexpr/runtime/table_interpreter.hpp>
#include <kanexpr/simulations/constraints/unit_norms.hpp>
#include <kanexpr/simulations/trim/trim.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <optional>
#include <string_view>

namespace kanexpr::simulations {

/// Evaluates [norms of quaternions; constraints; ẋ] of a system at the time t and [x; p; r].
class values_of_equations {
public:
  using number = std::complex<double>;

  explicit values_of_equations(const system_functions& system) : of_(system), norms_(system.known) {
    if (of_.constraints != nullptr) constraints_.emplace(*of_.constraints, of_.known);
    if (of_.rates != nullptr) rates_.emplace(*of_.rates, of_.known);
  }

  /// Returns what could not be solved there, as a sentence.
  std::string_view operator()(double t, const number* at, number* all) {
    for (int k = 0; k < norms_.count(); ++k) *all++ = norms_.residual(k, at);
    if (of_.compiled != nullptr) return of_.compiled(t, at, all);
    const derivation::survey& known = of_.known;
    const number* p = at + known.first_of(symbolic::symbol_kind::parameter);
    const number* r = at + known.first_of(symbolic::symbol_kind::input);
    const status kept = constraints_ ? constraints_->evaluate(t, at, p, r, all) : status();
    const status moved =
        rates_->evaluate(t, at, p, r, all + known.configuration_constraints + known.constraints);
    return (moved ? kept : moved).view();
  }

private:
  const system_functions& of_;
  simulations::unit_norms norms_;
  std::optional<runtime::table_interpreter<number>> constraints_{}, rates_{};
};

} // namespace kanexpr::simulations
