// expect: input T, which the torque on A contains, is not in the list of inputs
#include "pendulum.hpp"

constexpr input<"F"> F;

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            inputs<F>, loads<torque<A, T * N::z>>> {};

int main() { use<System>(); }
