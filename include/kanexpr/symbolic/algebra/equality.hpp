#pragma once

#include <kanexpr/base/engine.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/polynomials/budget.hpp>

namespace kanexpr::symbolic {

enum class equality {
  equal,     ///< wherever both are defined; proved
  different, ///< at some state; proved, or evident numerically
  undecided,
};

/// Determines whether two expressions have the same value everywhere. The result is decided for all
/// polynomials in symbols and in sines, cosines and tangents of sums of angles, and for quotients of these,
/// unless they have too many terms.
///
/// Other functions are treated as symbols, except that squares of square roots are simplified: expressions
/// found equal are equal. If relations between these functions might matter, or there are too many terms, a
/// numerical test can show that the expressions differ; otherwise, as for abs(x) and x, the result is
/// undecided. Decimal numbers have their exact binary value: 0.1 is not 1/10.
KANEXPR_ENGINE equality compare(expression a, expression b, std::size_t most_terms = default_max_terms);

/// Whether two expressions are proved to have the same value everywhere; `compare` distinguishes different
/// from undecided.
KANEXPR_ENGINE bool are_equal(expression a, expression b, std::size_t most_terms = default_max_terms);

} // namespace kanexpr::symbolic

#ifndef KANEXPR_COMPILED_ENGINE
#include <kanexpr/symbolic/algebra/compare.hpp>
#endif
