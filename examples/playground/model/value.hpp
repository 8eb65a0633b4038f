#pragma once

#include <kanexpr/mechanics/model/vector.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <utility>

namespace playground {

/// A scalar or a vector of a model.
struct value {
  kanexpr::symbolic::expression scalar{};
  kanexpr::mechanics::vector vector{};
  bool is_vector = false;

  static value of(kanexpr::symbolic::expression e) { return {.scalar = e}; }
  static value of(kanexpr::mechanics::vector v) { return {.vector = std::move(v), .is_vector = true}; }
};

} // namespace playground
