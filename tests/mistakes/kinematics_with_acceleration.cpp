// expect: a kinematic differential equation contains the rate of speed u
#include "pendulum.hpp"

struct System
    : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u + dot(u)>, bodies<Bob>> {};

int main() { use<System>(); }
