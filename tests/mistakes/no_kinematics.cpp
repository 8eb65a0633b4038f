// expect: the system System has no kinematics<...>
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, bodies<Bob>> {};

int main() { use<System>(); }
