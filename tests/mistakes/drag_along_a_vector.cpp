// expect: the drag at P multiplies a vector by a vector; write dot, cross or outer
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<drag<P, m * N::x>>> {};

int main() { use<System>(); }
