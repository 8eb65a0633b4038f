// expect: speed v, which a velocity constraint contains, is not in the list of speeds
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            velocity_constraints<u == v>> {};

int main() { use<System>(); }
