#pragma once

#include <kanexpr/mechanics/model/vector.hpp>

namespace kanexpr::mechanics {

struct body {
  name called{};
  int center = none; ///< the point of the mass centre
  int frame = none;  ///< none: a particle
  expression mass{};
  dyadic inertia{};
  int about = none;             ///< the point that the inertia is about
  bool inertia_changes = false; ///< as the body sees it, on purpose
  bool effective = false;       ///< the inertia need not be that of a distribution of mass
};

} // namespace kanexpr::mechanics
