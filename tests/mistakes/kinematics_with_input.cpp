// expect: a kinematic differential equation contains the input T, whose rate is not known
#include "pendulum.hpp"

struct System
    : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u + T>, bodies<Bob>> {};

int main() { use<System>(); }
