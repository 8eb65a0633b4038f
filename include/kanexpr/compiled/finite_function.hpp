#pragma once

#include <kanexpr/base/status.hpp>
#include <kanexpr/compiled/function.hpp>
#include <kanexpr/compiled/not_finite.hpp>
#include <kanexpr/compiled/status.hpp>
#include <kanexpr/compiled/windows.hpp>
#include <kanexpr/lower/scalar_math.hpp>
#include <kanexpr/lower/vector_columns.hpp>

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
  using own = function<System, wanted...>;

  template <std::size_t... index, class Found, class State, class Parameters = none, class Inputs = none,
            class Accelerations = none>
  [[gnu::always_inline]] static void check_results(std::index_sequence<index...>, Found& found,
                                                   const State& x, const Parameters& p = {},
                                                   const Inputs& r = {}, const Accelerations& = {}) {
    (check_result<index>(std::get<index>(found), x, p, r), ...);
  }

  template <std::size_t index, class Result, class State, class Parameters, class Inputs>
  [[gnu::always_inline]] static void check_result(with_status<Result>& result, const State& x,
                                                  const Parameters& p, const Inputs& r) {
    status s = result.status;
    if (s && !is_finite<index>(static_cast<const Result&>(result))) s = compiled::results_not_finite;
    if (!s) s = compiled::not_finite<System>::cause_of(s, x, p, r);
    result.status = s;
  }
  template <std::size_t, class Result, class State, class Parameters, class Inputs>
  static void check_result(const Result&, const State&, const Parameters&, const Inputs&) {
  } // results of an invalid call

  /// Of a result with fewer entries, compilers omit what need not be checked, and keep the others in
  /// registers.
  static constexpr int fewest_entries = 256;

  /// Always checks every entry that can differ from zero, so that the time does not depend on the state.
  template <std::size_t index, class Matrix>
  [[gnu::always_inline]] static bool is_finite(const Matrix& m) {
    using Number = typename Matrix::Scalar;
    constexpr int first = own::first_of(index);
    if constexpr (!std::is_same_v<Number, double> && !std::is_same_v<Number, float>) {
      bool all = true;
      for (Eigen::Index i = 0; i < m.size(); ++i)
        all = all & lower::scalar_math<Number>::is_finite(m.data()[i]);
      return all;
    } else if constexpr (Matrix::SizeAtCompileTime >= fewest_entries &&
                         own::has_many_zeros(first, static_cast<int>(Matrix::SizeAtCompileTime))) {
      return !bits<Number>::carries(
          carries_in<bits<Number>>(m.data(), own::template nonzero_windows<Matrix, first>::value));
    } else {
      typename bits<Number>::type carries = 0;
      for (Eigen::Index i = 0; i < m.size(); ++i)
        carries |= bits<Number>::next(std::bit_cast<typename bits<Number>::type>(m.data()[i]));
      return !bits<Number>::carries(carries);
    }
  }

  /// Adds 1 to the exponent, which carries into the sign if the number is not finite. Compilers evaluate
  /// several numbers at a time, and it works with -ffast-math.
  template <class Number>
  struct bits {
    using type = std::conditional_t<std::is_same_v<Number, double>, std::uint64_t, std::uint32_t>;
    static constexpr type exponent =
                              static_cast<type>(std::is_same_v<Number, double> ? std::uint64_t{0x7ff} << 52
                                                                               : std::uint64_t{0xff} << 23),
                          one = exponent & (~exponent + 1);

    template <class Bits>
    [[gnu::always_inline]] static Bits next(const Bits& number) {
      return (number & exponent) + one;
    }
    [[gnu::always_inline]] static bool carries(type sums) { return (sums & ~(exponent | (one - 1))) != 0; }
  };

  template <class Bits, class Number, int size, int width>
  [[gnu::always_inline]] static typename Bits::type carries_in(const Number* all,
                                                               const compiled::windows<size, width>& where) {
    typename Bits::type any = 0;
    if constexpr (width == 1) {
      for (int i = 0; i < where.count; ++i)
        any |= Bits::next(std::bit_cast<typename Bits::type>(all[where.first[i]]));
    } else {
      using several = lower::number_vector<typename Bits::type, width>;
      typename several::type sums{};
      for (int i = 0; i < where.count; ++i) {
        const typename several::type each =
            *reinterpret_cast<const typename several::in_memory*>(all + where.first[i]);
        sums |= Bits::next(each);
      }
      for (int i = 0; i < width; ++i) any |= sums[i];
    }
    return any;
  }
};

} // namespace kanexpr
