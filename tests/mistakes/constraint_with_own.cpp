// expect: an acceleration constraint contains own::x, which is valid only in the declared angular velocity of
// expect: a frame; write N::x
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            acceleration_constraints<zero_along<acceleration_of<P>, own::x>>> {};

int main() { use<System>(); }
