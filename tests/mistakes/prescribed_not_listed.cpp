// expect: input theta', which the force at P contains, is not in the list of inputs
#include "pendulum.hpp"

constexpr prescribed<"theta"> theta;

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            inputs<theta>, loads<force<P, dot(theta) * N::x>>> {};

int main() { use<System>(); }
