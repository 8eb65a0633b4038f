#pragma once

#include <kanexpr/symbolic/graph/expression.hpp>

namespace kanexpr::symbolic {

/// What stands for a symbol: a number, or an expression of symbols that stay.
struct replacement {
  expression symbol;
  expression by;
};

} // namespace kanexpr::symbolic
