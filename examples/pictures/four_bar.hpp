#pragma once

#include <kanexpr/animate/animated.hpp>
#include <models/four_bar.hpp>

namespace four_bar {

constexpr auto thickness = 0.06 * l1;

template <class Frame, class Joint>
using pin = show<cylinder<Frame, Joint, N::z, 1.2 * thickness, 3 * thickness>, colour<"#8f979e">>;

using picture =
    kanexpr::picture<System, up<N::y>, seen_from<N::z + 0.35 * N::x + 0.3 * N::y>,
                     trace<P1, colour<"#9fb4c8">>, trace<G2, colour<"#d98a2b">>, trace<P2, colour<"#9fb4c8">>,
                     show<rod<O, Bearing, thickness / 2>, colour<"#c4c8cb">, named<"ground">>,
                     show<rod<O, P1, thickness>, colour<"#b5382f">, named<"crank">>,
                     show<rod<P1, P2, thickness>, colour<"#3d6b99">, named<"coupler">>,
                     show<rod<P2, P3, thickness>, colour<"#5d8a4a">, named<"rocker">>,
                     show<sphere<G2, 1.3 * thickness>, colour<"#d98a2b">>, pin<N, O>, pin<A, P1>, pin<C, P2>,
                     pin<N, Bearing>>;

} // namespace four_bar
