// expect: the torque between A and N is a scalar; it must be a vector
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<torque_between<A, N, T>>> {};

int main() { use<System>(); }
