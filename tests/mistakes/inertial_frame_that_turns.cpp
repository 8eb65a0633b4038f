// expect: inertial<...> names frame A, which is oriented relative to N
#include "pendulum.hpp"

struct System : kane_system<inertial<A>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>> {};

int main() { use<System>(); }
