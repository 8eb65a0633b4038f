#pragma once

#include <kanexpr/compiled/out_of_line.hpp>
#include <models/simple_pendulum.hpp>

#ifndef FRICTION
#define FRICTION 1
#endif

/// A pendulum whose motion is compiled in a shared library, with the friction of that library.
namespace exchanged {

using namespace simple_pendulum;

struct System
    : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, parameters<m, l, g, c>,
                  bodies<Bob>, loads<gravity<g * N::x>, torque<A, -FRICTION * c * u * N::z>>> {};

using motion = function<System, mechanics::quantity::rhs>;

} // namespace exchanged

extern template struct kanexpr::compiled::instance<double, exchanged::motion>;
