#pragma once

#include <kanexpr/symbolic/graph/expression.hpp>

#include <string_view>

namespace kanexpr::mechanics {

/// A value of a load that must be positive, or must not be negative.
struct bounded_value {
  symbolic::expression value{};
  std::string_view of{}; ///< its name, such as "the stiffness of the contact between "
  bool is_positive = false;
};

} // namespace kanexpr::mechanics
