// expect: velocity_constraints<...> holds something that is not an equation, with u; write an equation or
// expect: zero_along<...>
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            velocity_constraints<u>> {};

int main() { use<System>(); }
