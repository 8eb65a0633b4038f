// expect: the damping of the stop with q is negative
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<stop<given_length<q>, 0.0, 1, 100, -0.1>>> {};

int main() { use<System>(); }
