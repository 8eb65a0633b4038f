// expect: the force at P normalizes a vector of zero length
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<force<P, normalized(N::x - N::x)>>> {};

int main() { use<System>(); }
