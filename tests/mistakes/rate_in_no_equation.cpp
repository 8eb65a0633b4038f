// expect: the rate of coordinate s appears in no kinematic differential equation
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q, s>, speeds<u, v>, kinematics<dot(q) == u, s == v>,
                            bodies<Bob>> {};

int main() { use<System>(); }
