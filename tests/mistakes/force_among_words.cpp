// expect: the force at P is among the words of System; list it in loads<...>
#include "pendulum.hpp"

struct System
    : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>, weight> {};

int main() { use<System>(); }
