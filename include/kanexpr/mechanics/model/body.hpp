#pragma once

#include <kanexpr/mechanics/model/vector.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

namespace kanexpr::mechanics {

struct body {
  name called{};
  int center = none; ///< the mass center
  int frame = none;  ///< none: a particle
  expression mass{};
  dyadic inertia{};
  int about = none;             ///< the reference point of the inertia
  bool inertia_changes = false; ///< declared to change in the body frame
  bool effective = false;       ///< need not be the inertia of a mass distribution
};

} // namespace kanexpr::mechanics
