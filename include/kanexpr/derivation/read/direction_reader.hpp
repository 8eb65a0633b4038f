#pragma once

#include <kanexpr/derivation/read/load_parts.hpp>
#include <kanexpr/mechanics/loads/contact_geometry.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/vector.hpp>

#include <string_view>

namespace kanexpr::derivation {

/// Reads the direction of a vector that is given in the axes of one frame, which is returned in `frame`.
constexpr mechanics::components read_direction(load_parts& by, const phrase& p, std::string_view what,
                                               int& frame) {
  const mechanics::vector v = by.vector(p, what);
  if (by.has_mistake()) return mechanics::components(*by.model().g);
  const mechanics::contact_direction d = mechanics::contact_direction_of(by.model(), v);
  if (!d.mistake.empty()) by.fail({what, by.whom, d.mistake});
  frame = d.frame;
  return d.unit;
}

} // namespace kanexpr::derivation
