// expect: zero_along<...> of a configuration constraint with P has no direction
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            configuration_constraints<zero_along<position_of<P, O>>>> {};

int main() { use<System>(); }
