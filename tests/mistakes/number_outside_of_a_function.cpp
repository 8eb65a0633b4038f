// expect: the mass of Disc contains acos of a number for which it is undefined
#include "pendulum.hpp"

struct Disc : particle<Disc, P, m * acos(rational<2, 1>)> {};

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Disc>> {};

int main() { use<System>(); }
