#pragma once

#include <kanexpr/lower/complex_math.hpp>
#include <kanexpr/runtime/table_interpreter.hpp>
#include <kanexpr/simulate/trim.hpp>
#include <kanexpr/simulate/unit_norms.hpp>

#include <optional>

namespace kanexpr::trim {

/// [norms of quaternions; constraints; ẋ] of a system at the time t and [x; p; r].
class evaluation {
public:
  using number = std::complex<double>;

  explicit evaluation(const subject& system) : of_(system), norms_(system.known) {
    if (of_.table != nullptr) interpreted_.emplace(*of_.table, of_.known);
  }

  /// What could not be solved there, as a sentence.
  std::string_view operator()(double t, const number* at, number* all) {
    for (int k = 0; k < norms_.count(); ++k) *all++ = norms_.residual(k, at);
    if (!interpreted_) return of_.compiled(t, at, all);
    const number* p = at + of_.known.first_of(symbolic::symbol_kind::parameter);
    const number* r = at + of_.known.first_of(symbolic::symbol_kind::input);
    return interpreted_->evaluate(t, at, p, r, all).cause();
  }

private:
  const subject& of_;
  simulated::unit_norms norms_;
  std::optional<runtime::table_interpreter<number>> interpreted_{};
};

} // namespace kanexpr::trim
