// expect: the force at P subtracts or equates a vector and a scalar
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<force<P, T * N::x - 3>>> {};

int main() { use<System>(); }
