#pragma once

#include <kanexpr/base/sentence.hpp>

#include <string>

namespace kanexpr::simulations {

/// The cause of a failure of an integrator or solver, as a sentence; empty if it did not fail.
struct failure {
  std::string sentence{};

  explicit operator bool() const { return !sentence.empty(); }
};

/// The last error message of SUNDIALS, for the sentence of a failure.
struct last_error {
  std::string message{};

  /// The error handler of all SUNDIALS packages; the default one would print the message.
  static void handle(int, const char*, const char*, char* message, void* receiver) {
    static_cast<last_error*>(receiver)->message = message;
  }
};

} // namespace kanexpr::simulations
