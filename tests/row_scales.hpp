// Scales for the regularity of a matrix.
#pragma once

#include <kanexpr/symbolic/linear_system.hpp>

/// The sum of the magnitudes of each row's entries, or 1; columns have the scale 1.
constexpr auto row_scales(const kanexpr::symbolic::matrix& a) {
  kanexpr::symbolic::sequence<kanexpr::symbolic::expression> scales;
  for (int i = 0; i < a.rows; ++i) {
    kanexpr::symbolic::expression sum = abs(a(i, 0));
    for (int j = 1; j < a.columns; ++j) sum += abs(a(i, j));
    scales.push(sum + (1 - sign(sum)));
  }
  for (int j = 0; j < a.columns; ++j) scales.push({a.entries[0].owner(), kanexpr::symbolic::graph::one});
  return scales;
}
