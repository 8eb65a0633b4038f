#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/compiled/call.hpp>
#include <kanexpr/compiled/status.hpp>
#include <kanexpr/compiled/survey_of.hpp>
#include <kanexpr/derivation/extract_code.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/lower/scalar_math.hpp>
#include <kanexpr/lower/unrolled_tape.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <Eigen/Core>

/// The parts of a compiled function: its tape, and the arguments that the tape loads.
namespace kanexpr {

namespace compiled {

/// The code for a set of results of a system, derived once for each set.
template <class System, auto... wanted>
struct derived_code {
  static constexpr base::sentence mistake() { return extracted.mistake; }

protected:
  static constexpr derivation::extracted_code extracted = derivation::code_for<System, wanted...>();
};

/// The tape of a set of results. A mistake in them is a compile-time error.
template <class System, auto... wanted>
struct code : private derived_code<System, wanted...> {
  using system = System;

private:
  using derived_code<System, wanted...>::extracted;

public:
  static constexpr auto tape = lower::trimmed<extracted.tape.sizes>(extracted.tape);
  static constexpr auto causes = derivation::trimmed<extracted.causes.sizes>(extracted.causes);
  static constexpr base::sentence mistake = extracted.mistake;
  static constexpr bool follows_from_unparsed = extracted.follows_from_unparsed;
  static constexpr bool checks_finiteness = extracted.checks_finiteness;
  static_assert(derivation::report<code>());
};

/// Selects the arguments of a call that the code loads.
template <class System, class Number, class State, class Parameters, class Inputs, class Accelerations,
          class Weights, class Direction>
struct arguments {
  const Number& t;
  const State& x;
  const Parameters& p;
  const Inputs& r;
  const Accelerations& a;
  const Weights& w;
  const Direction& v;

  template <symbolic::symbol_kind from, int position>
  [[gnu::always_inline]] Number operator()() const noexcept {
    using symbolic::symbol_kind;
    if constexpr (from == symbol_kind::time)
      return t;
    else if constexpr (from == symbol_kind::coordinate)
      return lower::scalar_math<Number>::from(x[position]);
    else if constexpr (from == symbol_kind::speed)
      return lower::scalar_math<Number>::from(x[survey_of<System>.coordinates + position]);
    else if constexpr (from == symbol_kind::parameter)
      return lower::scalar_math<Number>::from(p[position]);
    else if constexpr (from == symbol_kind::speed_rate)
      return lower::scalar_math<Number>::from(a[position]);
    else if constexpr (from == symbol_kind::weight)
      return lower::scalar_math<Number>::from(w[position]);
    else if constexpr (from == symbol_kind::direction)
      return lower::scalar_math<Number>::from(v[position]);
    else
      return lower::scalar_math<Number>::from(r[position]);
  }
};

/// Returns a placeholder for a result that cannot be computed; a result that is a scalar or vector for every
/// system remains one.
template <class Number, auto wanted>
auto no_result_of() {
  constexpr derivation::extent size =
      derivation::extent_of(derivation::requested<wanted>::value, derivation::survey{});
  if constexpr (size.rows == 1 && size.columns == 1)
    return lower::scalar_math<Number>::from(0);
  else if constexpr (size.rows > 0 && size.columns > 0)
    return with_status<Eigen::Matrix<Number, size.rows, size.columns>>();
  else
    return no_result<Number>();
}

template <auto wanted, class System>
inline constexpr derivation::extent extent_of =
    derivation::extent_of(derivation::requested<wanted>::value, survey_of<System>);

template <class System, auto... wanted>
struct derives {};

} // namespace compiled

} // namespace kanexpr
