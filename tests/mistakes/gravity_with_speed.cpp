// expect: gravity contains the speed u; it may contain only parameters, inputs and time
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<gravity<-g * N::y + 0.1 * velocity_of<P>>>> {};

int main() { use<System>(); }
