// expect: the force at P is a constraint; it must be an expression
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<force<P, zero_along<N::x, N::y>>>> {};

int main() { use<System>(); }
