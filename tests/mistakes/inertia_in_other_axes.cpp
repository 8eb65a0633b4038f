// expect: the inertia of Rotor is given along the axes of A and changes as seen from B, the body frame; if
// expect: this is intended, write changing_inertia<...>
#include "pendulum.hpp"

struct B : rotated<B, A, s, A::x> {};
struct Rotor : rigid_body<Rotor, P, B, m, inertia<A, 1, 2, 3>> {};

struct System : kane_system<inertial<N>, coordinates<q, s>, speeds<u, v>,
                            kinematics<dot(q) == u, dot(s) == v>, bodies<Rotor>> {};

int main() { use<System>(); }
