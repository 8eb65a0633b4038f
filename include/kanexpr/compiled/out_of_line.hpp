#pragma once

#include <kanexpr/compiled/digest.hpp>
#include <kanexpr/compiled/finite_function.hpp>
#include <kanexpr/compiled/instance.hpp>
#include <kanexpr/compiled/linked_model.hpp>
#include <kanexpr/compiled/status.hpp>
#include <kanexpr/compiled/survey_of.hpp>
#include <kanexpr/lower/scalar_math.hpp>

#include <Eigen/Core>

#include <type_traits>
#include <utility>

namespace kanexpr {

namespace compiled {

template <class System, auto wanted>
struct result_shape {
  static constexpr derivation::extent size = extent_of<wanted, System>;
  static constexpr int rows = size.rows, columns = size.columns;
  static constexpr bool is_scalar = size.scalar;
};

template <class Number, class Found>
void put(with_status<Number>& result, const Found& found) {
  if constexpr (requires { result.value; })
    result.value = found;
  else
    static_cast<Number&>(result) = found;
  result.status = status_of(found);
}
template <class... Number, class... Found>
void put(std::tuple<Number...>& results, const std::tuple<Found...>& found) {
  [&]<std::size_t... index>(std::index_sequence<index...>) {
    (put(std::get<index>(results), std::get<index>(found)), ...);
  }(std::index_sequence_for<Number...>{});
}

/// Returns the results of a function, each with a status.
template <class Results, class Function, class... Given>
[[gnu::always_inline]] inline Results results_of(const Given&... given) noexcept {
  Results all{};
  put(all, Function{}(given...));
  return all;
}

template <class Number, class Function, int alignment>
typename instance<Number, Function, alignment>::results
instance<Number, Function, alignment>::evaluate(const Number& t, const typename vectors::state& x,
                                                const typename vectors::parameters& p,
                                                const typename vectors::inputs& r) noexcept {
  return results_of<results, Function>(t, x, p, r);
}

template <class Number, class Function, int alignment>
std::uint64_t instance<Number, Function, alignment>::digest() noexcept {
  return digest_of_function<Function>;
}

template <class Number, class Function, int alignment>
typename instance_at_rates<Number, Function, alignment>::results
instance_at_rates<Number, Function, alignment>::evaluate(const Number& t, const typename vectors::state& x,
                                                         const typename vectors::parameters& p,
                                                         const typename vectors::inputs& r,
                                                         const typename vectors::rates& a) noexcept {
  return results_of<results, Function>(t, x, p, r, a);
}

/// Whether a vector can be passed out of line. A call with any other type is forwarded to the function
/// itself, which reports the mistake.
template <class System, symbols_of which, class Given>
constexpr bool can_forward() {
  if constexpr (std::is_same_v<Given, omitted>)
    return false;
  else
    return (entries_of<Given>() == Eigen::Dynamic ||
            entries_of<Given>() == range_of(which, survey_of<System>).size) &&
           can_be_vector<System, which, Given>;
}

} // namespace compiled

/// A function whose code is compiled once per program and scalar type and then called, with bitwise identical
/// results. Each result has a status.
///
/// `function<System, …>` itself is expanded at every call, as a control loop requires, unless it is long
/// (lower::lengths). `out_of_line` compiles any function only once, regardless of the number of calls.
template <class Function>
struct out_of_line {
  template <class Time, class State, class Parameters, class Inputs>
  auto operator()(const Time& t, const State& x, const Parameters& p, const Inputs& r) const noexcept {
    using System = typename compiled::results_with_status<Function>::System;
    using Number = typename State::Scalar;
    using vectors = compiled::vectors<System, Number>;
    using compiled::symbols_of;
    if constexpr (compiled::can_forward<System, symbols_of::state, State>() &&
                  compiled::can_forward<System, symbols_of::parameters, Parameters>() &&
                  compiled::can_forward<System, symbols_of::inputs, Inputs>())
      return code<System, Number>::evaluate(lower::scalar_math<Number>::from(t),
                                            compiled::forwarded<typename vectors::state>(x),
                                            compiled::forwarded<typename vectors::parameters>(p),
                                            compiled::forwarded<typename vectors::inputs>(r));
    else
      return Function{}(t, x, p, r);
  }
  template <class Time, class State, class Parameters, class Inputs, class Accelerations>
  auto operator()(const Time& t, const State& x, const Parameters& p, const Inputs& r,
                  const Accelerations& a) const noexcept {
    using System = typename compiled::results_with_status<Function>::System;
    using Number = typename State::Scalar;
    using vectors = compiled::vectors<System, Number>;
    return code_at_rates<System, Number>::evaluate(
        lower::scalar_math<Number>::from(t), compiled::forwarded<typename vectors::state>(x),
        compiled::forwarded<typename vectors::parameters>(p),
        compiled::forwarded<typename vectors::inputs>(r), compiled::forwarded<typename vectors::rates>(a));
  }

  /// Identifies the function by its system, its code and the version of the library, regardless of which file
  /// contains the code for `double`.
  static std::uint64_t digest() noexcept {
    return code<typename compiled::results_with_status<Function>::System, double>::digest();
  }

private:
  template <class System, class Number>
  using code =
      std::conditional_t<compiled::is_in_library<System, Number, Function>(),
                         compiled::linked_instance<Number, Function>, compiled::instance<Number, Function>>;
  template <class System, class Number>
  using code_at_rates = std::conditional_t<compiled::is_in_library<System, Number, Function, true>(),
                                           compiled::linked_instance_at_rates<Number, Function>,
                                           compiled::instance_at_rates<Number, Function>>;
};

} // namespace kanexpr
