#pragma once

#include <kanexpr/animate/animated.hpp>
#include <models/spinning_top.hpp>

namespace spinning_top {

struct Shoulder : offset<Shoulder, O, 1.3 * l * F2::z> {};
struct Handle : offset<Handle, O, 2.1 * l * F2::z> {};

using picture = kanexpr::picture<System, up<N::z>, ground<>, trace<Handle, colour<"#d98a2b">>,
                                 show<cone<B, O, F2::z, 0.85 * l, 1.3 * l>, colour<"#b5382f">, named<"top">>,
                                 show<rod<Shoulder, Handle, 0.07 * l>, colour<"#e0b25a">>>;

} // namespace spinning_top
