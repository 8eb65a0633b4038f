#pragma once

#include <kanexpr/symbolic/algebra/expansion_reader.hpp>
#include <kanexpr/symbolic/algebra/forms.hpp>

namespace kanexpr::symbolic {

KANEXPR_ENGINE rewritten expand(expression e, std::size_t most_terms) {
  algebra::budget left(most_terms);
  const auto sums = algebra::expansion_reader(e.owner(), left).read({e.node()});
  if (left.failed()) return {e, "the expression cannot be multiplied out: " + left.cause()};
  return {algebra::sum_in(e.owner(), sums.front()), {}};
}

} // namespace kanexpr::symbolic
