#pragma once

/// Transforms results of a run-time derivation: expand, collect, reduce to lowest terms, combine sines and
/// cosines, and compare for equality. Requires Boost.Multiprecision.

#include <kanexpr/symbolic.hpp>
#include <kanexpr/symbolic/algebra/equality.hpp>
#include <kanexpr/symbolic/algebra/forms.hpp>
