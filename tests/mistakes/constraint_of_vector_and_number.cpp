// expect: a velocity constraint subtracts or equates a vector and a scalar
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            velocity_constraints<velocity_of<P> == 0>> {};

int main() { use<System>(); }
