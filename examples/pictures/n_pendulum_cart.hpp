#pragma once

#include <kanexpr/animate/animated.hpp>
#include <models/n_pendulum_cart.hpp>

namespace n_pendulum_cart {

/// The parts of one pendulum.
using picture =
    kanexpr::picture<System<1>, up<N::y>, ground<-0.075>, seen_from<N::z + 0.3 * N::x + 0.2 * N::y>,
                     trace<P<1>>, show<box<N, P<0>, 0.4, 0.15, 0.2>, colour<"#3d6b99">>,
                     show<rod<P<0>, P<1>, 0.02>>, show<sphere<P<1>, 0.07>, colour<"#b5382f">>>;

} // namespace n_pendulum_cart
