// expect: the potential energy with m is among the words of System; list it in loads<...>
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            potential_energy<m * q * q>> {};

int main() { use<System>(); }
