// expect: the torque on A contains a number that is not finite
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<torque<A, dot(1e200 * N::x - 1e150 * N::z, 1e200 * N::x) * N::z>>> {};

int main() { use<System>(); }
