#pragma once

#include <string>
#include <utility>

namespace kanexpr {

/// The result of an operation: success, or the cause of its failure.
class [[nodiscard]] outcome {
public:
  outcome() = default;
  explicit outcome(std::string cause) : cause_(std::move(cause)) {}

  explicit operator bool() const { return cause_.empty(); }
  /// Why the operation failed, as a sentence; empty on success.
  std::string cause() const { return cause_; }

private:
  std::string cause_{};
};

} // namespace kanexpr
