// expect: the inertia of Rod is given about O, which moves in B, the body frame; if this is intended, write
// expect: changing_inertia<...>
#include "pendulum.hpp"

struct B : rotated<B, A, s, A::z> {};
struct Q : offset<Q, P, l * B::x> {};
struct Rod : rigid_body<Rod, Q, B, m, inertia_about<O, inertia<B, 1, 20, 20>>> {};

struct System : kane_system<inertial<N>, coordinates<q, s>, speeds<u, v>,
                            kinematics<dot(q) == u, dot(s) == v>, bodies<Rod>> {};

int main() { use<System>(); }
