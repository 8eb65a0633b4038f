// expect: the system System has no bodies<...>
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>> {};

int main() { use<System>(); }
