// expect: an acceleration constraint holds own::x, which stands for a frame while its angular velocity is
// expect: declared; write N::x
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            acceleration_constraints<zero_along<acceleration_of<P>, own::x>>> {};

int main() { use<System>(); }
