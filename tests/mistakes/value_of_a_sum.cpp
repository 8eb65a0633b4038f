// expect: values<...> takes equations such as m == 2.5 for parameters, but contains a different expression
// expect: with m
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            values<m + g == 2>> {};

int main() { use<System>(); }
