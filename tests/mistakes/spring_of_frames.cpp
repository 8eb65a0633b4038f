// expect: A, which the spring between A and O uses as a point, is a frame
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<spring<A, O, m>>> {};

int main() { use<System>(); }
