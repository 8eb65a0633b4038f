// expect: gravity contains the coordinate q; it may contain only parameters, inputs and time
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<gravity<-g * q * N::y>>> {};

int main() { use<System>(); }
