#pragma once

#include <kanexpr/base/engine.hpp>
#include <kanexpr/symbolic/algebra/rewritten.hpp>
#include <kanexpr/symbolic/graph/matrix.hpp>
#include <kanexpr/symbolic/polynomials/budget.hpp>

/// Other forms of expressions.
namespace kanexpr::symbolic {

/// Products multiplied out, in arguments of functions too: a sum of products of powers. A sum under a bar
/// stays there, multiplied out: (a + b)/(c d + c e) becomes a/(c (d + e)) + b/(c (d + e)).
/// Systems of equations of order 1 to 3 are written out, larger ones are symbols.
KANEXPR_ENGINE rewritten expand(expression e, std::size_t most_terms = usual_most_terms);

/// A sum gathered by the powers of some symbols or functions, such as u1 or sin(q1): every power of them
/// occurs once, with one coefficient, which is multiplied out. What stands under a bar or in a function is no
/// power.
KANEXPR_ENGINE rewritten collect(expression e, const sequence<expression>& by,
                                 std::size_t most_terms = usual_most_terms);

/// A quotient of polynomials in symbols, and in functions taken as symbols, in lowest terms: the numerator
/// multiplied out, but for what all of its terms share, the denominator in the factors in which it came.
/// Squares of square roots vanish; other relations between functions are not used (see
/// trigonometric_normal_form).
KANEXPR_ENGINE rewritten cancel(expression e, std::size_t most_terms = usual_most_terms);

/// Sums of products of symbols with one sine or cosine of a sum of angles each: of two polynomials in symbols
/// and in sines and cosines of such sums, with fractions up to sixteenths in front of the angles, the forms
/// are the same node if and only if they are equal. Tangents are quotients of sine and cosine. A quotient
/// that remains is written over factors, and may have other forms (compare in equality.hpp knows). Other
/// functions are symbols; decimal numbers are what their bits say.
KANEXPR_ENGINE rewritten trigonometric_normal_form(expression e, std::size_t most_terms = usual_most_terms);

/// The form with the fewest operations among an expression itself, with small linear systems written out; the
/// same in lowest terms (`cancel`); and in lowest terms after its sines and cosines were brought together
/// (`trigonometric_normal_form`). Forms with more than `most_terms` terms are left out.
KANEXPR_ENGINE expression simplify(expression e, std::size_t most_terms = 1000);

/// Every entry by itself.
KANEXPR_ENGINE matrix simplify(matrix m, std::size_t most_terms = 1000);

} // namespace kanexpr::symbolic

#ifndef KANEXPR_COMPILED_ENGINE
#include <kanexpr/symbolic/algebra/collect.hpp>
#include <kanexpr/symbolic/algebra/expand.hpp>
#include <kanexpr/symbolic/algebra/simplify.hpp>
#endif
