// expect: parameter m is bound to a value, but is also in the list of parameters
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            parameters<m, l>, values<m == 2>> {};

int main() { use<System>(); }
