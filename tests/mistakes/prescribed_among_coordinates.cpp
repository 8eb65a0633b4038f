// expect: prescribed quantity theta is in the list of coordinates
#include "pendulum.hpp"

constexpr prescribed<"theta"> theta;

struct System
    : kane_system<inertial<N>, coordinates<q, theta>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>> {};

int main() { use<System>(); }
