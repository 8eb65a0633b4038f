// expect: the inertia of Wheel is not the same from all sides of the axis about which B turns without an
// angle; if expect: that is meant, write changing_inertia<...>
#include "pendulum.hpp"

struct B : rotated<B, A, 0, A::x>, angular_velocity<A, v * A::x> {};
struct Wheel : rigid_body<Wheel, P, B, m, inertia<B, 1, 2, 3>> {};

struct System
    : kane_system<inertial<N>, coordinates<q>, speeds<u, v>, kinematics<dot(q) == u>, bodies<Wheel>> {};

int main() { use<System>(); }
