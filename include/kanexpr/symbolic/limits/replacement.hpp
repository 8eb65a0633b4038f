#pragma once

#include <kanexpr/symbolic/graph/expression.hpp>

namespace kanexpr::symbolic {

/// The replacement of a symbol: a number, or an expression in the remaining symbols.
struct replacement {
  expression symbol;
  expression by;
};

} // namespace kanexpr::symbolic
