// The control: nothing is wrong here, so this must compile.
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<weight, torque<A, T * N::z>>> {};

int main() { use<System>(); }
