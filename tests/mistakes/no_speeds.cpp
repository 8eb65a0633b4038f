// expect: the system System has no speeds<...>
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, kinematics<dot(q) == u>, bodies<Bob>> {};

int main() { use<System>(); }
