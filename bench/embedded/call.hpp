#pragma once

#include <kanexpr/kanexpr.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

/// How the measured programs pass arguments and results, in plain arrays.
namespace embedded {

/// The arguments of a call: the state, the inputs, the parameters, one behind the other.
template <class System, class T>
struct arguments {
  using eom = kanexpr::equations_of_motion<System>;
  static constexpr int size_of_x = eom::state::SizeAtCompileTime, size_of_r = eom::inputs::SizeAtCompileTime,
                       size_of_p = eom::parameters::SizeAtCompileTime;

  Eigen::Map<const Eigen::Matrix<T, size_of_x, 1>> x;
  Eigen::Map<const Eigen::Matrix<T, size_of_r, 1>> r;
  Eigen::Map<const Eigen::Matrix<T, size_of_p, 1>> p;

  explicit arguments(const T* given) : x(given), r(given + size_of_x), p(given + size_of_x + size_of_r) {}
};

/// How many of them vary from call to call: all but the parameters.
template <class System>
inline constexpr std::size_t state_and_inputs =
    static_cast<std::size_t>(arguments<System, double>::size_of_x + arguments<System, double>::size_of_r);

/// Writes the entries of a result and returns what comes behind them. Few of them are written without a loop.
template <class T, class Result>
[[gnu::always_inline]] inline T* put(T* found, const Result& result) {
  constexpr std::size_t size = Result::SizeAtCompileTime;
  if constexpr (size <= 32)
    [&]<std::size_t... i>(std::index_sequence<i...>) __attribute__((always_inline)) {
      ((found[i] = result.data()[i]), ...);
    }(std::make_index_sequence<size>{});
  else
    std::copy_n(result.data(), size, found);
  return found + size;
}

/// The value, or the end of the range that is nearer to it: without a branch.
template <class T>
T within(T value, T least, T most) {
  return (std::abs(value - least) - std::abs(value - most) + (least + most)) / 2;
}

/// 1 where there is a result, else 0.
template <class T>
T as_number(const kanexpr::status& s) {
  return T(static_cast<bool>(s));
}

} // namespace embedded
