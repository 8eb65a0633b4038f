// expect: frame M, which P uses, is not connected to the inertial frame N
#include "pendulum.hpp"

struct M : inertial_frame<M> {};

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<force<P, -m * g * M::y>>> {};

int main() { use<System>(); }
