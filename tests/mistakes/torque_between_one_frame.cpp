// expect: a torque acts between frame A and itself
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<torque_between<A, A, T * N::z>>> {};

int main() { use<System>(); }
