#pragma once

#include <string>
#include <utility>

namespace kanexpr {

/// Whether something was done and, if not, why not.
class [[nodiscard]] outcome {
public:
  outcome() = default;
  explicit outcome(std::string cause) : cause_(std::move(cause)) {}

  explicit operator bool() const { return cause_.empty(); }
  /// Why it was not done, as a sentence; empty: it was.
  std::string cause() const { return cause_; }

private:
  std::string cause_{};
};

} // namespace kanexpr
