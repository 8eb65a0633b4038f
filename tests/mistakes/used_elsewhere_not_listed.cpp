// expect: parameter g, which used_elsewhere<...> contains, is not in the list of parameters
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            parameters<m, l>, used_elsewhere<g>> {};

int main() { use<System>(); }
