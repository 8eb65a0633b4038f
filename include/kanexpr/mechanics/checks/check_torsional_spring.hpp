#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/mechanics/model/contents.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <string_view>

namespace kanexpr::mechanics {

/// Reports a torsional spring that has no restoring torque or whose stiffness depends on a coordinate. `of`
/// names it, as in "the torsional spring with q".
constexpr base::sentence check_torsional_spring(const mechanism& m, expression angle, expression stiffness,
                                                expression rest, std::string_view of) {
  using kind = symbolic::symbol_kind;
  const contents held(*m.g);
  if (!held.holds(angle, kind::coordinate) && !held.holds(rest, kind::coordinate))
    return base::sentence(
        {"the angle of ", of, " contains no coordinate; pass the angle first, then the stiffness"});
  if (held.holds(stiffness, kind::coordinate))
    return base::sentence({"the stiffness of ", of, " contains the coordinate ",
                           held.name_of(stiffness, kind::coordinate),
                           "; it may contain only parameters, inputs and time"});
  return {};
}

} // namespace kanexpr::mechanics
