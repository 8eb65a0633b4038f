// expect: a kinematic differential equation is not linear in the rate of coordinate q
#include "pendulum.hpp"

struct System
    : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) * dot(q) == u>, bodies<Bob>> {};

int main() { use<System>(); }
