#pragma once

#include <kanexpr/base/engine.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/polynomials/budget.hpp>

namespace kanexpr::symbolic {

enum class equality {
  equal,     ///< wherever both are defined: this is proved
  different, ///< somewhere: proved, or seen clearly in numbers
  undecided,
};

/// Whether two expressions have the same value everywhere. Polynomials in symbols and in sines, cosines and
/// tangents of sums of angles, and quotients of these, are always decided, if there are not too many terms.
///
/// Other functions are taken as symbols, but for squares of square roots: what is equal then is equal. Where
/// their relations might matter, and where there are too many terms, numbers decide whether it is different;
/// if they do not, as for abs(x) and x, it is undecided. Decimal numbers are what their bits say: 0.1 is not
/// 1/10.
KANEXPR_ENGINE equality compare(expression a, expression b, std::size_t most_terms = usual_most_terms);

/// Whether two expressions are proved to have the same value everywhere; `compare` tells what is different
/// from what is not known.
KANEXPR_ENGINE bool are_equal(expression a, expression b, std::size_t most_terms = usual_most_terms);

} // namespace kanexpr::symbolic

#ifndef KANEXPR_COMPILED_ENGINE
#include <kanexpr/symbolic/algebra/compare.hpp>
#endif
