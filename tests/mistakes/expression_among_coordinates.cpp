// expect: the list of coordinates contains something that is not a symbol, involving s
#include "pendulum.hpp"

struct System
    : kane_system<inertial<N>, coordinates<q, 2 * s>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>> {};

int main() { use<System>(); }
