// expect: the system System has no inertial<...>
#include "pendulum.hpp"

struct System : kane_system<coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>> {};

int main() { use<System>(); }
