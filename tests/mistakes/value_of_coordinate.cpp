// expect: coordinate q is bound to a value; only parameters can be bound
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            values<q == 2>> {};

int main() { use<System>(); }
