// expect: Wind is not a word of a system, but System lists it
#include "pendulum.hpp"

struct Wind {};

struct System
    : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>, Wind> {};

int main() { use<System>(); }
