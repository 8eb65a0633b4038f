// expect: expected as many kinematic differential equations as coordinates, got 1 for 2
#include "pendulum.hpp"

struct System
    : kane_system<inertial<N>, coordinates<q, s>, speeds<u>, kinematics<dot(q) + dot(s) == u>, bodies<Bob>> {
};

int main() { use<System>(); }
