// expect: potential energy 1 contains the speed u; it may contain only coordinates
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<potential_energy<m * u * u / 2>>> {};

int main() { use<System>(); }
