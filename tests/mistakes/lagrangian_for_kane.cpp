// expect: the system System has lagrangian<...>, which only a lagrange_system takes
#include "pendulum.hpp"

struct System
    : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, lagrangian<m * u * u>> {};

int main() { use<System>(); }
