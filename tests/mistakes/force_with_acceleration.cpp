// expect: the force at P contains the rate of speed u
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<force<P, m * dot(u) * N::y>>> {};

int main() { use<System>(); }
