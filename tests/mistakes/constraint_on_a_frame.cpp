// expect: A, which a configuration constraint uses as a point, is a frame
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            configuration_constraints<zero_along<position_of<A, O>, N::x>>> {};

int main() { use<System>(); }
