// expect: the system System has no coordinates<...>
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>> {};

int main() { use<System>(); }
