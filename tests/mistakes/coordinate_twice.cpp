// expect: q is listed twice among the coordinates
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q, q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>> {
};

int main() { use<System>(); }
