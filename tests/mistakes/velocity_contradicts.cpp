// expect: the velocity of point Q is not the rate of its position; if this is intended, write
// expect: velocity_apart_from_position
#include "pendulum.hpp"

struct Q : offset<Q, O, s * A::x>, velocity<N, v * A::x> {};
struct Bead : particle<Bead, Q, m> {};

struct System : kane_system<inertial<N>, coordinates<q, s>, speeds<u, v>,
                            kinematics<dot(q) == u, dot(s) == v>, bodies<Bead, Bob>> {};

int main() { use<System>(); }
