// expect: the value of parameter m is not a number: it contains g
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            values<m == 2 * g>> {};

int main() { use<System>(); }
