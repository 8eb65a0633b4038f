// expect: speed v, which dependent<...> contains, is not in the list of speeds
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            velocity_constraints<u == 0>, dependent<v>> {};

int main() { use<System>(); }
