#pragma once

#include <kanexpr/mechanics/problem.hpp>

#include <limits>
#include <type_traits>

namespace kanexpr {

/// Whether all that an evaluation had to solve could be solved at its state. Where it could not, the results
/// beside it mean nothing.
class status {
public:
  static constexpr int room = 32; ///< for causes

  constexpr status() = default;
  constexpr status(const mechanics::problem* causes, unsigned failed) : causes_(causes), failed_(failed) {}

  /// Whether the results can be used.
  constexpr explicit operator bool() const { return failed_ == 0; }

  /// What could not be solved, as a sentence; empty: nothing.
  constexpr std::string_view cause() const {
    int first = 0;
    if (failed_ == 0) return {};
    while ((failed_ >> first & 1u) == 0) ++first;
    return causes_[first].view();
  }

private:
  const mechanics::problem* causes_ = nullptr;
  unsigned failed_ = 0; ///< a bit for each cause
};

namespace mechanics {

/// How near to singular is too near: a pivot so small beside its row that rounding decides.
template <class T>
constexpr double least_regularity() {
  if constexpr (std::is_arithmetic_v<T>)
    return 4096.0 * static_cast<double>(std::numeric_limits<T>::epsilon());
  else
    return 4096.0 * std::numeric_limits<double>::epsilon();
}

} // namespace mechanics

} // namespace kanexpr
