// expect: velocity_constraints<...> contains something that is not an equation, involving u; write an
// expect: equation or zero_along<...>
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            velocity_constraints<u>> {};

int main() { use<System>(); }
