// expect: auxiliary speed v appears in dependent<...>; it is zero at all times
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            auxiliary<v>, velocity_constraints<u == v>, dependent<v>> {};

int main() { use<System>(); }
