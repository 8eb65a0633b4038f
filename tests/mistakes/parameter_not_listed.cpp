// expect: parameter m, which the mass of Bob contains, is not in the list of parameters
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            parameters<l, g>> {};

int main() { use<System>(); }
