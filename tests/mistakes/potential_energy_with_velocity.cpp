// expect: the potential energy with m holds a velocity or derivative; it may hold coordinates only
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<potential_energy<m * dot(velocity_of<P>, N::x)>>> {};

int main() { use<System>(); }
