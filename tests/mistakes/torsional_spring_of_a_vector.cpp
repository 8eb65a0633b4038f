// expect: the angle of the torsional spring with A is a vector; it must be a scalar
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<torsional_spring<A::x, m>>> {};

int main() { use<System>(); }
