// expect: input T, which the force at P contains, is not in the list of inputs
#include "pendulum.hpp"

constexpr input<"F"> F;

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            inputs<F>, loads<force<P, F * N::x - T * velocity_of<P>>>> {};

int main() { use<System>(); }
