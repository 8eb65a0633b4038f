#pragma once

#include <kanexpr/animate/animated.hpp>
#include <models/rolling_disc.hpp>

namespace rolling_disc {

using picture = kanexpr::picture<System, up<N::z>, ground<>, carried<Dmc>, trace<C, colour<"#2f5d8a">>,
                                 show<cylinder<R, Dmc, R::y, r, r / 25>, colour<"#c8683f">, named<"disc">>>;

} // namespace rolling_disc
