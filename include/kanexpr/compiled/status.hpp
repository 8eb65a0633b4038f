#pragma once

#include <kanexpr/base/status.hpp>

#include <type_traits>

namespace kanexpr {

/// A result with the status of its evaluation: `if (!udot.status) …`.
template <class Result>
struct with_status : Result {
  kanexpr::status status{};
  with_status() noexcept {} // leaves the entries uninitialized
  with_status(const Result& result, const kanexpr::status& s) : Result(result), status(s) {}
};

/// A number with the status of its evaluation.
template <class Result>
  requires(!std::is_class_v<Result>)
struct with_status<Result> {
  Result value;
  kanexpr::status status;
  operator Result() const { return value; }
};

/// Returns the status of any result; success if the result has no status because its evaluation cannot fail.
template <class Result>
constexpr status status_of(const Result& result) {
  if constexpr (requires { status(result.status); })
    return result.status;
  else
    return {};
}

} // namespace kanexpr
