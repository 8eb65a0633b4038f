// expect: the kinematic differential equations cannot be solved for the rate of coordinate q
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q, s>, speeds<u, v>,
                            kinematics<dot(q) + dot(s) == u, 2 * dot(q) + 2 * dot(s) == v>, bodies<Bob>> {};

int main() { use<System>(); }
