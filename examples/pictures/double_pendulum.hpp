#pragma once

#include <kanexpr/animate/animated.hpp>
#include <models/double_pendulum.hpp>

namespace double_pendulum {

struct Tip : offset<Tip, J, 2 * d2 * B::x> {};

using picture = kanexpr::picture<
    System, up<N::y>, ground<-1.15 * (l1 + 2 * d2)>, seen_from<N::z + 0.4 * N::x + 0.15 * N::y>,
    trace<Tip, colour<"#d98a2b">>, show<cylinder<N, O, N::z, 0.06 * l1, 0.16 * l1>, colour<"#8f979e">>,
    show<rod<O, J, 0.035 * l1>, colour<"#3d6b99">>,
    show<cylinder<B, J, N::z, 0.055 * l1, 0.1 * l1>, colour<"#8f979e">>,
    show<rod<J, Tip, 0.035 * l1>, colour<"#b5382f">>, show<sphere<Tip, 0.06 * l1>, colour<"#b5382f">>>;

} // namespace double_pendulum
