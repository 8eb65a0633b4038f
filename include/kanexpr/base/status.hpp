#pragma once

#include <limits>
#include <string>
#include <string_view>
#include <type_traits>

namespace kanexpr {

/// Whether all that an evaluation had to solve could be solved at its state. Where it could not, the results
/// beside it mean nothing.
class status {
public:
  constexpr status() = default;
  /// The first of what could not be solved, as a sentence that outlives the status.
  constexpr explicit status(std::string_view cause) : cause_(cause) {}

  /// Whether the results can be used.
  constexpr explicit operator bool() const { return cause_.empty(); }

  /// What could not be solved, as a sentence; empty: nothing.
  constexpr std::string cause() const { return std::string(cause_); }
  /// The same where there is no heap.
  constexpr std::string_view view() const { return cause_; }

private:
  std::string_view cause_{};
};

/// The cause; nothing where there is none.
template <class Stream>
auto operator<<(Stream& to, const status& told) -> decltype(to << told.view()) {
  return to << told.view();
}

namespace mechanics {

/// What is left beside what it was made of, so small that rounding decides on it.
inline constexpr double vanishing_measure = 4096.0 * std::numeric_limits<double>::epsilon();

/// How near to singular is too near. A solution has the rounding of its matrix divided by this as its error:
/// of double precision one in a million, of single precision four digits are left. Of one of the compiler's
/// vectors, of its numbers.
template <class Scalar>
constexpr double least_singularity_measure() {
  if constexpr (std::is_same_v<Scalar, float>)
    return 4096.0 * static_cast<double>(std::numeric_limits<float>::epsilon());
  else if constexpr (!std::is_class_v<Scalar> && requires(const Scalar v) { v[0]; })
    return least_singularity_measure<std::remove_cvref_t<decltype(Scalar{}[0])>>();
  else
    return 1e6 * std::numeric_limits<double>::epsilon();
}

} // namespace mechanics

} // namespace kanexpr
