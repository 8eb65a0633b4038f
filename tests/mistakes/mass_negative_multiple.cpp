// expect: the mass of Ball is negative
#include "pendulum.hpp"

struct Ball : particle<Ball, P, -2 * m> {};

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Ball>> {};

int main() { use<System>(); }
