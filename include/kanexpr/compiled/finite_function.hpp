#pragma once

#include <kanexpr/base/status.hpp>
#include <kanexpr/compiled/function.hpp>
#include <kanexpr/compiled/not_finite.hpp>
#include <kanexpr/compiled/status.hpp>
#include <kanexpr/lower/scalar_math.hpp>

#include <Eigen/Core>

#include <bit>
#include <cstdint>
#include <type_traits>
#include <utility>

namespace kanexpr {

/// @internal A function with several results, each with a status, even if no equations had to be solved. If a
/// result is not finite, its status reports this and names the argument that was not finite.
template <class System, auto... wanted>
struct finite_function : function<System, wanted...>, compiled::callable<finite_function<System, wanted...>> {
  using compiled::callable<finite_function>::operator();

  template <class First, class... More>
  [[gnu::always_inline]] static auto called(const First& first, const More&... more) noexcept {
    auto found = function<System, wanted...>::template evaluate_at<true>(first, more...);
    constexpr auto each = std::index_sequence_for<decltype(wanted)...>{};
    if constexpr (requires { First::SizeAtCompileTime; }) // the first argument is a vector, not the time
      check_results(each, found, first, more...);
    else
      check_results(each, found, more...);
    return found;
  }

private:
  using none = compiled::omitted;

  template <std::size_t... index, class Found, class State, class Parameters = none, class Inputs = none,
            class Accelerations = none>
  [[gnu::always_inline]] static void check_results(std::index_sequence<index...>, Found& found,
                                                   const State& x, const Parameters& p = {},
                                                   const Inputs& r = {}, const Accelerations& = {}) {
    (check_result(std::get<index>(found), x, p, r), ...);
  }

  template <class Result, class State, class Parameters, class Inputs>
  [[gnu::always_inline]] static void check_result(with_status<Result>& result, const State& x,
                                                  const Parameters& p, const Inputs& r) {
    status s = result.status;
    if (s && !is_finite(result)) s = status("a result is not finite at this state");
    if (!s) s = compiled::not_finite<System>::cause_of(s, x, p, r);
    result.status = s;
  }
  template <class Result, class State, class Parameters, class Inputs>
  static void check_result(const Result&, const State&, const Parameters&, const Inputs&) {
  } // results of an invalid call

  /// Always checks every entry, so that the time does not depend on the state.
  template <class Matrix>
  [[gnu::always_inline]] static bool is_finite(const Matrix& m) {
    using Number = typename Matrix::Scalar;
    if constexpr (std::is_same_v<Number, double>) {
      return has_no_carry(m.data(), m.size(), std::uint64_t{0x7ff} << 52, std::uint64_t{1} << 52);
    } else if constexpr (std::is_same_v<Number, float>) {
      return has_no_carry(m.data(), m.size(), std::uint32_t{0xff} << 23, std::uint32_t{1} << 23);
    } else {
      bool all = true;
      for (Eigen::Index i = 0; i < m.size(); ++i)
        all = all & lower::scalar_math<Number>::is_finite(m.data()[i]);
      return all;
    }
  }

  /// Adds 1 to each exponent, which carries into the sign if the number is not finite. Compilers evaluate
  /// several numbers at a time, and it works with -ffast-math.
  template <class Number, class Bits>
  [[gnu::always_inline]] static bool has_no_carry(const Number* all, Eigen::Index count, Bits exponent,
                                                  Bits one) {
    Bits carries = 0;
    for (Eigen::Index i = 0; i < count; ++i) carries |= (std::bit_cast<Bits>(all[i]) & exponent) + one;
    return (carries & ~(exponent | (one - 1))) == 0;
  }
};

} // namespace kanexpr
