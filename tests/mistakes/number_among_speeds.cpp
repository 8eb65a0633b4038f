// expect: the list of speeds contains something that is not a symbol
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u, 2>, kinematics<dot(q) == u>, bodies<Bob>> {
};

int main() { use<System>(); }
