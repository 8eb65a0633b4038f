// expect: gravity is given along the axes of A, which turn with coordinate q; it may contain only parameters,
// expect: inputs and time
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<gravity<-g * A::y>>> {};

int main() { use<System>(); }
