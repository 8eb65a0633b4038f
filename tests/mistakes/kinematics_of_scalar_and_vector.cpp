// expect: a kinematic differential equation subtracts or equates a scalar and a vector
#include "pendulum.hpp"

struct System
    : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u * A::z>, bodies<Bob>> {};

int main() { use<System>(); }
