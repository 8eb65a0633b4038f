// expect: a torsional damper acts between frame A and itself
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<torsional_damper<A, A, m>>> {};

int main() { use<System>(); }
