#pragma once

#include <kanexpr/animate/animated.hpp>
#include <models/iiwa.hpp>

namespace iiwa {

struct Tip : offset<Tip, Link7_joint, 0.12 * Link7::z> {};

template <class From, class To, auto radius>
using tube = show<rod<From, To, radius>, colour<"#c4c8cb">>;
template <class Joint, auto radius>
using joint = show<sphere<Joint, radius>, colour<"#d98a2b">>;

using picture =
    kanexpr::picture<System, up<N::z>, ground<>, seen_from<N::x - 1.2 * N::y + 0.6 * N::z>,
                     trace<Tip, colour<"#2f5d8a">>, show<cylinder<N, O, N::z, 0.11, 0.04>, colour<"#8f979e">>,
                     tube<O, Link1_joint, 0.075>, tube<Link1_joint, Link2_joint, 0.07>,
                     tube<Link2_joint, Link3_joint, 0.065>, tube<Link3_joint, Link4_joint, 0.06>,
                     tube<Link4_joint, Link5_joint, 0.055>, tube<Link5_joint, Link6_joint, 0.05>,
                     tube<Link6_joint, Link7_joint, 0.045>, joint<Link2_joint, 0.085>,
                     joint<Link4_joint, 0.075>, joint<Link6_joint, 0.06>,
                     show<rod<Link7_joint, Tip, 0.03>, colour<"#b5382f">, named<"tool">>>;

} // namespace iiwa
