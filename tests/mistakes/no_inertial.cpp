// expect: the system System is told no inertial<...>
#include "pendulum.hpp"

struct System : kane_system<coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>> {};

int main() { use<System>(); }
