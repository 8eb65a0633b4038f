#pragma once

#include <kanexpr/base/engine.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/matrix.hpp>
#include <kanexpr/symbolic/graph/substitute.hpp>

#include <string>
#include <vector>

/// Values at an operating point, with limits where substitution gives 0/0.
namespace kanexpr::symbolic {

/// A matrix entry that has neither a value nor a limit, and the reason as a sentence.
struct singularity {
  int row = 0;
  int column = 0;
  std::string condition;
};

/// The values of a matrix at a point; singular entries are NaN.
struct point_values {
  matrix values;
  std::vector<singularity> singular; ///< empty if all values were found
};

/// Evaluates expressions with symbols simultaneously replaced by numbers or by expressions in the remaining
/// symbols. Where substitution gives no value, the limit is computed from series along straight lines; the
/// entry is singular if the limit depends on the direction or is not finite.
///
/// A denominator counts as zero if it vanishes at generic values of the remaining symbols; a number counts as
/// zero if it is zero within a running bound on its rounding error (bounded.hpp). Functions without a power
/// series, such as sqrt(q) and log(q) at q = 0, have no limit here even if a one-sided limit exists.
KANEXPR_ENGINE point_values limits_at(graph& g, const matrix& m, const std::vector<replacement>& point);

} // namespace kanexpr::symbolic

#ifndef KANEXPR_COMPILED_ENGINE
#include <kanexpr/symbolic/limits/limits.hpp>
#endif
