// expect: the torque on A is a scalar; it must be a vector
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<torque<A, T>>> {};

int main() { use<System>(); }
