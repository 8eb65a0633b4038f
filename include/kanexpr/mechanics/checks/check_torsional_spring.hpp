#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/mechanics/model/contents.hpp>

namespace kanexpr::mechanics {

/// A torsional spring that turns nothing back, or whose stiffness would be a load of its own. `of`: "the
/// torsional spring with q".
constexpr sentence check_torsional_spring(const mechanism& m, expression angle, expression stiffness,
                                          expression rest, std::string_view of) {
  using kind = symbolic::symbol_kind;
  const contents held(*m.g);
  if (!held.holds(angle, kind::coordinate) && !held.holds(rest, kind::coordinate))
    return sentence({"the angle of ", of, " holds no coordinate; the angle comes first, then the stiffness"});
  if (held.holds(stiffness, kind::coordinate))
    return sentence({"the stiffness of ", of, " holds the coordinate ",
                     held.name_of(stiffness, kind::coordinate),
                     "; it may hold parameters, inputs and time only"});
  return {};
}

} // namespace kanexpr::mechanics
