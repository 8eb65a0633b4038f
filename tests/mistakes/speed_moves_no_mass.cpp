// expect: speed v moves no mass
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q, s>, speeds<u, v>,
                            kinematics<dot(q) == u, dot(s) == v>, bodies<Bob>> {};

int main() { use<System>(); }
