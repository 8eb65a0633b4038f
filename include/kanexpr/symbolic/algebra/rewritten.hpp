#pragma once

#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/polynomials/budget.hpp>

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

namespace algebra {

/// Reads an expression and writes it in the form of a reader.
template <class Reader>
rewritten rewrite(expression e, std::size_t most_terms, const std::string& failure) {
  polynomials::budget left(most_terms);
  Reader reader(e.owner(), left);
  const auto values = reader.read({e.node()});
  const expression result = left.failed() ? e : reader.written(values.front());
  if (left.failed()) return {e, failure + left.cause()};
  return {result, {}};
}

} // namespace algebra

} // namespace kanexpr::symbolic
