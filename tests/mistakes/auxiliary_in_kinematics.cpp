// expect: a kinematic differential equation contains the auxiliary speed v
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, auxiliary<v>, kinematics<dot(q) == u + v>,
                            bodies<Bob>> {};

int main() { use<System>(); }
