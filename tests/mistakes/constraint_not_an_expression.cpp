// expect: configuration_constraints<...> contains something that is not an equation; write an equation or
// expect: zero_along<...>
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            configuration_constraints<nullptr>> {};

int main() { use<System>(); }
