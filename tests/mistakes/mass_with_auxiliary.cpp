// expect: the mass of Ball depends on the auxiliary speed v
#include "pendulum.hpp"

struct Ball : particle<Ball, P, m * v> {};

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, auxiliary<v>, kinematics<dot(q) == u>,
                            bodies<Ball>> {};

int main() { use<System>(); }
