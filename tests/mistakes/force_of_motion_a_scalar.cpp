// expect: the force at P is a scalar; it must be a vector
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<force<P, -m * magnitude(velocity_of<P>)>>> {};

int main() { use<System>(); }
