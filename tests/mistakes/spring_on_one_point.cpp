// expect: a spring acts between point P and itself
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<spring<P, P, m>>> {};

int main() { use<System>(); }
