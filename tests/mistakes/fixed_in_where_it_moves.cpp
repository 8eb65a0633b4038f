// expect: point Q is fixed in N, but its offset from S changes in that frame; if this is intended, write
// expect: velocity_apart_from_position
#include "pendulum.hpp"

struct Q : offset<Q, S, -l * A::y>, fixed_in<N> {}; // A
struct Rod : rigid_body<Rod, Q, A, m, inertia<A, 0, 0, m * l * l>> {};

struct System : kane_system<inertial<N>, coordinates<q, s>, speeds<u, v>,
                            kinematics<dot(q) == u, dot(s) == v>, bodies<Rod, Block>> {};

int main() { use<System>(); }
