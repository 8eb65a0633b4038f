// expect: coordinate q is given a value; only parameters have one
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            values<q == 2>> {};

int main() { use<System>(); }
