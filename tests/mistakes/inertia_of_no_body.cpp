// expect: the inertia of Rod is that of no body: one principal moment is larger than the other two together;
// expect: if it is meant, write effective_inertia<...> around it
#include "pendulum.hpp"

struct Rod : rigid_body<Rod, P, A, m, inertia<A, 1, 1, 3>> {};

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Rod>> {};

int main() { use<System>(); }
