// expect: the greatest length of the stop with q contains the coordinate q; it may contain only parameters,
// expect: inputs and time
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<stop<given_length<q>, 0.0, 2 * q, 100, 0.1>>> {};

int main() { use<System>(); }
