// expect: expected as many kinematic differential equations as coordinates, got 2 for 1
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>,
                            kinematics<dot(q) == u, 2 * dot(q) == 2 * u>, bodies<Bob>> {};

int main() { use<System>(); }
