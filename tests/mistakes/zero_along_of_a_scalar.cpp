// expect: zero_along<...> of a velocity constraint with u has a first argument that is not a vector
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            velocity_constraints<zero_along<u, N::x>>> {};

int main() { use<System>(); }
