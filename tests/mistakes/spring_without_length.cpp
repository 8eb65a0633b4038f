// expect: the spring between P and Pin has zero length in every configuration
#include "pendulum.hpp"

struct Pin : offset<Pin, O, l * A::x> {};

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<spring<P, Pin, m>>> {};

int main() { use<System>(); }
