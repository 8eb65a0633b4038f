// expect: zero_along<...> of a velocity constraint with P has a direction of zero length
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            velocity_constraints<zero_along<velocity_of<P>, 0.0 * N::x>>> {};

int main() { use<System>(); }
