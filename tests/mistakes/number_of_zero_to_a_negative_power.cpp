// expect: the force at P contains pow of numbers for which it is undefined
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<force<P, q * pow(rational<0, 1>, -1) * N::x>>> {};

int main() { use<System>(); }
