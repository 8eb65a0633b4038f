#pragma once

/// Results of a derivation at run time in other forms: multiplied out, collected, in lowest terms, with sines
/// and cosines brought together, and whether two of them are equal. Needs Boost.Multiprecision.

#include <kanexpr/symbolic.hpp>
#include <kanexpr/symbolic/algebra/equality.hpp>
#include <kanexpr/symbolic/algebra/forms.hpp>
