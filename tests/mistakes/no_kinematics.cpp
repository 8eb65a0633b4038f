// expect: the system System is told no kinematics<...>
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, bodies<Bob>> {};

int main() { use<System>(); }
