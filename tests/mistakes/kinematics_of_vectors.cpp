// expect: a kinematic differential equation with q equates vectors; equate their dot products with
// expect: basis vectors
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) * N::z == u * A::z>,
                            bodies<Bob>> {};

int main() { use<System>(); }
