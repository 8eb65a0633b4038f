#pragma once

#include <kanexpr/base/engine.hpp>
#include <kanexpr/symbolic/graph/matrix.hpp>
#include <kanexpr/symbolic/limits/replacement.hpp>

#include <string>
#include <vector>

/// Values at an operating point, with limits where they are 0/0.
namespace kanexpr::symbolic {

/// An entry of a matrix that has no value and no limit, and why, as a sentence.
struct singularity {
  int row = 0;
  int column = 0;
  std::string condition;
};

/// The values of a matrix at a point; not-a-number at the entries that are singular.
struct point_values {
  matrix values;
  std::vector<singularity> singular; ///< empty: all values were found
};

/// The values of expressions where symbols are replaced, all at once, by numbers or by expressions of symbols
/// that stay. What has no value there by substitution has its limit, found by series along straight lines;
/// where it depends on the direction, or is not finite, the entry is singular.
///
/// A denominator counts as zero where it vanishes at generic values of the symbols that stay, and a number
/// where it is zero within a running bound on what rounding did to it (bounded.hpp). Functions without a
/// power series, such as sqrt(q) and log(q) at q = 0, have no limit here even where one side has.
KANEXPR_ENGINE point_values limits_at(graph& g, const matrix& m, const std::vector<replacement>& point);

} // namespace kanexpr::symbolic

#ifndef KANEXPR_COMPILED_ENGINE
#include <kanexpr/symbolic/limits/limits.hpp>
#endif
