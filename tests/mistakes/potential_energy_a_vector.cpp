// expect: the potential energy with m is a vector; it must be a scalar
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<potential_energy<m * N::x>>> {};

int main() { use<System>(); }
