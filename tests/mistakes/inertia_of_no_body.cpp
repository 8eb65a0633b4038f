// expect: the inertia of Rod is not physical: one principal moment exceeds the sum of the other two; if this
// expect: is intended, wrap it in effective_inertia<...>
#include "pendulum.hpp"

struct Rod : rigid_body<Rod, P, A, m, inertia<A, 1, 1, 3>> {};

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Rod>> {};

int main() { use<System>(); }
