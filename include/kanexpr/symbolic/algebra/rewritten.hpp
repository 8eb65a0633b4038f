#pragma once

#include <kanexpr/symbolic/graph/expression.hpp>

#include <string>

namespace kanexpr::symbolic {

/// An expression in a new form. If the rewriting failed, it is the original expression and `cause` gives the
/// reason. The value is the same in either case, and the result converts to an expression.
struct rewritten {
  expression value;
  std::string cause;

  explicit operator bool() const { return cause.empty(); }
  operator expression() const { return value; }
};

} // namespace kanexpr::symbolic
