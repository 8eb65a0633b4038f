#pragma once

#include <string>

namespace kanexpr::solvers {

/// Why an integrator or solver ended, in a sentence; no sentence: it did not fail.
struct failure {
  std::string sentence{};

  explicit operator bool() const { return !sentence.empty(); }
};

/// What SUNDIALS says of its last error, for the sentence of a failure.
struct last_error {
  std::string message{};

  /// The error handler of all its packages, which would print it.
  static void take(int, const char*, const char*, char* message, void* taker) {
    static_cast<last_error*>(taker)->message = message;
  }
};

} // namespace kanexpr::solvers
