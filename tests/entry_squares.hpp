// Squares for the singularity measure of a matrix.
#pragma once

#include <kanexpr/symbolic/linear/linear_system.hpp>

/// The squares of the entries, row by row.
constexpr auto entry_squares(const kanexpr::symbolic::matrix& a) {
  kanexpr::base::sequence<kanexpr::symbolic::expression> squares;
  for (const kanexpr::symbolic::expression& e : a.entries) squares.push(e * e);
  return squares;
}
