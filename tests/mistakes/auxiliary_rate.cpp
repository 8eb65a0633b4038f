// expect: the force at P contains the rate of auxiliary speed v, which is zero at all times
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            auxiliary<v>, loads<force<P, m * dot(v) * N::x>>> {};

int main() { use<System>(); }
