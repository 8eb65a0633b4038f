#pragma once

#include <kanexpr/base/engine.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/symbolic/algebra/rewritten.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/matrix.hpp>
#include <kanexpr/symbolic/polynomials/budget.hpp>

/// Alternative forms of expressions.
namespace kanexpr::symbolic {

/// Multiplies out products, also in arguments of functions, into a sum of products of powers. A sum in a
/// denominator stays there, multiplied out: (a + b)/(c d + c e) becomes a/(c (d + e)) + b/(c (d + e)). Linear
/// systems of order 1 to 3 are expanded; larger ones are treated as symbols.
KANEXPR_ENGINE rewritten expand(expression e, std::size_t most_terms = default_max_terms);

/// Collects a sum by powers of symbols or functions such as u1 or sin(q1): each power occurs once, with one
/// expanded coefficient. Occurrences in denominators or inside functions are not collected.
KANEXPR_ENGINE rewritten collect(expression e, const sequence<expression>& by,
                                 std::size_t most_terms = default_max_terms);

/// Reduces a quotient of polynomials in symbols, and in functions treated as symbols, to lowest terms: the
/// numerator is multiplied out except for common factors of its terms, and the denominator keeps the factors
/// of the original expression. Squares of square roots are simplified; other relations between functions are
/// not used (see trigonometric_normal_form).
KANEXPR_ENGINE rewritten cancel(expression e, std::size_t most_terms = default_max_terms);

/// Returns a sum of products of symbols, each with at most one sine or cosine of a sum of angles. For
/// polynomials in symbols and in sines and cosines of such sums, with angle multiples down to sixteenths, the
/// forms are the same node if and only if the polynomials are equal. Tangents are quotients of sine and
/// cosine. A remaining quotient keeps a factored denominator and may have several forms (use `compare` in
/// equality.hpp). Other functions are treated as symbols; decimal numbers have their exact binary value.
KANEXPR_ENGINE rewritten trigonometric_normal_form(expression e, std::size_t most_terms = default_max_terms);

/// Returns the form with the fewest operations among three: the expression with small linear systems
/// expanded, its reduction to lowest terms (`cancel`), and its reduction to lowest terms after combining
/// sines and cosines (`trigonometric_normal_form`). Forms with more than `most_terms` terms are not
/// considered.
KANEXPR_ENGINE expression simplify(expression e, std::size_t most_terms = 1000);

/// Simplifies each entry separately.
KANEXPR_ENGINE matrix simplify(matrix m, std::size_t most_terms = 1000);

} // namespace kanexpr::symbolic

#ifndef KANEXPR_COMPILED_ENGINE
#include <kanexpr/symbolic/algebra/expand.hpp>
#include <kanexpr/symbolic/algebra/simplify.hpp>
#endif
