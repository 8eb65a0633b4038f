// expect: the kinematic differential equations cannot be solved for the rate of coordinate s
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q, s>, speeds<u, v>,
                            kinematics<dot(q) + dot(s) == u, u == v>, bodies<Bob>> {};

int main() { use<System>(); }
