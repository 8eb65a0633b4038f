// expect: coordinate s has its rate in no kinematic differential equation
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q, s>, speeds<u, v>, kinematics<dot(q) == u, s == v>,
                            bodies<Bob>> {};

int main() { use<System>(); }
