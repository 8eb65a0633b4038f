// expect: the system System is told no coordinates<...>
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>> {};

int main() { use<System>(); }
