// expect: parameter m is bound to two values
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            values<m == 2, m == 3>> {};

int main() { use<System>(); }
