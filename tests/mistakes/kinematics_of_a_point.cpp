// expect: P, which kinematics_of uses as a frame, is a point
#include "pendulum.hpp"

struct System
    : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<kinematics_of<P, N>>, bodies<Bob>> {};

int main() { use<System>(); }
