// expect: potential energy 1 contains the rate of coordinate q
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<potential_energy<m * dot(q) * dot(q) / 2>>> {};

int main() { use<System>(); }
