// expect: speed u is in the list of coordinates
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q, u>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>> {
};

int main() { use<System>(); }
