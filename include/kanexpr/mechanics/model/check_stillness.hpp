#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/mechanics/model/contents.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/wording.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <string_view>

namespace kanexpr::mechanics {

/// Reports speeds or rates in a quantity that must be a function of coordinates, parameters, inputs and time.
constexpr sentence check_stillness(const mechanism& m, const contents& held, expression e,
                                   std::string_view of, std::string_view whose) {
  using kind = symbolic::symbol_kind;
  if (held.holds(e, kind::speed))
    return sentence({of, whose, " contains the ", speed_called(m, held.name_of(e, kind::speed)).view(),
                     "; it may contain only coordinates"});
  if (held.holds(e, kind::auxiliary_speed))
    return sentence({of, whose, " contains the auxiliary speed ", held.name_of(e, kind::auxiliary_speed),
                     "; it may contain only coordinates"});
  if (held.holds(e, kind::coordinate_rate))
    return sentence({of, whose, " contains the rate of coordinate ", held.name_of(e, kind::coordinate_rate)});
  if (held.holds(e, kind::speed_rate))
    return sentence(
        {of, whose, " contains the ", speed_rate_called(m, held.name_of(e, kind::speed_rate)).view()});
  return {};
}

} // namespace kanexpr::mechanics
