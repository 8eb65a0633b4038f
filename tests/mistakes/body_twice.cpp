// expect: body Bob is listed twice
#include "pendulum.hpp"

struct System
    : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob, Bob>> {};

int main() { use<System>(); }
