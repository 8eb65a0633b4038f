#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/symbolic/graph/composition.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/tabulated.hpp>

namespace kanexpr::symbolic {

/// Applies a composition to its operands.
constexpr expression compose(composition f, const sequence<expression>& x) {
  switch (f) {
  case composition::hypot: return hypot(x[0], x[1]);
  case composition::if_positive: return if_positive(x[0], x[1], x[2]);
  case composition::min: return (min)(x[0], x[1]);
  case composition::max: return (max)(x[0], x[1]);
  case composition::clamp: return clamp(x[0], x[1], x[2]);
  case composition::smooth_abs: return smooth_abs(x[0], x[1]);
  case composition::softplus: return softplus(x[0], x[1]);
  case composition::smooth_step: return smooth_step(x[0], x[1], x[2]);
  case composition::tabulated: return tabulated(x[0], &x[1], (x.size() - 1) / 2);
  case composition::periodic: return periodic(x[0], &x[1], (x.size() - 1) / 2);
  }
  __builtin_unreachable();
}

} // namespace kanexpr::symbolic
