// expect: the value of parameter g contains a number that is not finite
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<weight>, values<g == 9.81 * rational<1, 0>>> {};

int main() { use<System>(); }
