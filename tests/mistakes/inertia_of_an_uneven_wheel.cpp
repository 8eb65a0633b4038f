// expect: the inertia of Wheel is not axisymmetric about the spin axis of B, whose angle is omitted; if this
// expect: is intended, write changing_inertia<...>
#include "pendulum.hpp"

struct B : rotated<B, A, 0, A::x>, angular_velocity<A, v * A::x> {};
struct Wheel : rigid_body<Wheel, P, B, m, inertia<B, 1, 2, 3>> {};

struct System
    : kane_system<inertial<N>, coordinates<q>, speeds<u, v>, kinematics<dot(q) == u>, bodies<Wheel>> {};

int main() { use<System>(); }
