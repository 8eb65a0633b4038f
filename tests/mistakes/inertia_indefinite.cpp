// expect: the inertia of Rod is indefinite: its moment about some axis is negative
#include "pendulum.hpp"

struct Rod : rigid_body<Rod, P, A, m, inertia<A, 2, 2, 2, 3>> {};

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Rod>> {};

int main() { use<System>(); }
