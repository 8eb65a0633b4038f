#pragma once

#include <limits>
#include <string>
#include <string_view>
#include <type_traits>

namespace kanexpr {

/// Indicates whether all equations that an evaluation had to solve were solvable at the given state. If not,
/// the accompanying results are meaningless.
class status {
public:
  constexpr status() = default;
  /// The first failure, as a message that outlives the status.
  constexpr explicit status(std::string_view cause) : cause_(cause) {}

  /// True if the results can be used.
  constexpr explicit operator bool() const { return cause_.empty(); }

  /// The cause of the failure, as a sentence; empty on success.
  constexpr std::string cause() const { return std::string(cause_); }
  /// The same as `cause()`, without using the heap.
  constexpr std::string_view view() const { return cause_; }

private:
  std::string_view cause_{};
};

/// Prints the cause, or nothing if there is none.
template <class Stream>
auto operator<<(Stream& to, const status& told) -> decltype(to << told.view()) {
  return to << told.view();
}

namespace base {

/// A remainder this small, relative to the terms that it is computed from, is dominated by rounding.
inline constexpr double vanishing_measure = 4096.0 * std::numeric_limits<double>::epsilon();

/// The smallest measure that is not treated as singular. The relative error of a solution is at most the
/// rounding error of its matrix divided by this bound. The bound is 1e-6 in double precision; in single
/// precision it leaves four correct digits. For a compiler vector type, returns the bound for its element
/// type.
template <class Scalar>
constexpr double least_singularity_measure() {
  if constexpr (std::is_same_v<Scalar, float>)
    return 4096.0 * static_cast<double>(std::numeric_limits<float>::epsilon());
  else if constexpr (!std::is_class_v<Scalar> && requires(const Scalar v) { v[0]; })
    return least_singularity_measure<std::remove_cvref_t<decltype(Scalar{}[0])>>();
  else
    return 1e6 * std::numeric_limits<double>::epsilon();
}

} // namespace base

} // namespace kanexpr
