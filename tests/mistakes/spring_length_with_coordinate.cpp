// expect: the natural length of the spring between P and O contains the coordinate q; it may contain only
// expect: parameters, inputs and time
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<spring<P, O, m, l * cos(q)>>> {};

int main() { use<System>(); }
