// expect: the stiffness of the stop with q is not positive
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<stop<given_length<q>, 0.0, 1, 0.0, 0.1>>> {};

int main() { use<System>(); }
