// expect: zero_along<...> of a velocity constraint with P has a direction that is not a vector
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            velocity_constraints<zero_along<velocity_of<P>, N::x, 1>>> {};

int main() { use<System>(); }
