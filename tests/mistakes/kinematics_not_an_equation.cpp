// expect: kinematics<...> contains something that is not an equation, involving q; write dot(q) == u
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) - u>, bodies<Bob>> {};

int main() { use<System>(); }
