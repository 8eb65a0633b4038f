// expect: the inertia of Rotor is given in axes of A and changes as seen from B, with which the body turns;
// if expect: that is meant, write changing_inertia<...>
#include "pendulum.hpp"

struct B : rotated<B, A, s, A::x> {};
struct Rotor : rigid_body<Rotor, P, B, m, inertia<A, 1, 2, 3>> {};

struct System : kane_system<inertial<N>, coordinates<q, s>, speeds<u, v>,
                            kinematics<dot(q) == u, dot(s) == v>, bodies<Rotor>> {};

int main() { use<System>(); }
