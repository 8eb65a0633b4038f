// expect: the potential energy with m contains a velocity or derivative; it may contain only coordinates
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<potential_energy<m * dot(velocity_of<P>, N::x)>>> {};

int main() { use<System>(); }
