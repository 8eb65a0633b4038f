// expect: speed v appears in no kinematic differential equation
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u, v>, kinematics<dot(q) == u>, bodies<Bob>> {
};

int main() { use<System>(); }
