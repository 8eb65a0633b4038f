#pragma once

#include <kanexpr/symbolic/graph/expression.hpp>

#include <string>

namespace kanexpr::symbolic {

/// An expression in another form. Where that could not be reached it is the old one, and `cause` says why: it
/// has the same value in any case, and may be used as an expression.
struct rewritten {
  expression value;
  std::string cause;

  explicit operator bool() const { return cause.empty(); }
  operator expression() const { return value; }
};

} // namespace kanexpr::symbolic
