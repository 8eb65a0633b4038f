// expect: a kinematic differential equation is not linear in the speed u
#include "pendulum.hpp"

struct System
    : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == sin(u)>, bodies<Bob>> {};

int main() { use<System>(); }
