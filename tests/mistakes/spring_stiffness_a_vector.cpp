// expect: the stiffness of the spring between P and O is a vector; it must be a scalar
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<spring<P, O, m * N::x>>> {};

int main() { use<System>(); }
