// expect: a cubic spring acts between point P and itself
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<cubic_spring<through<O, P, P>, 3, 1>>> {};

int main() { use<System>(); }
