// expect: body Bob is among the words of System; write bodies<Bob>
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, Bob> {};

int main() { use<System>(); }
