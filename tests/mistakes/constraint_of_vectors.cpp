// expect: a velocity constraint with u equates vectors; write zero_along<vector, directions>
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            velocity_constraints<velocity_of<P> == u * N::x>> {};

int main() { use<System>(); }
