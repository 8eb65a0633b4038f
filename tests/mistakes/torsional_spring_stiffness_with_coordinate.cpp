// expect: the stiffness of the torsional spring with q contains the coordinate q; it may contain only
// expect: parameters, inputs and time
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<torsional_spring<q, m * q>>> {};

int main() { use<System>(); }
