// expect: kinematics_of<A, N> is not available: frame A has no declared angular velocity
#include "pendulum.hpp"

struct System
    : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<kinematics_of<A, N>>, bodies<Bob>> {};

int main() { use<System>(); }
