// expect: the force between P and O is a scalar; it must be a vector
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<force_between<P, O, T>>> {};

int main() { use<System>(); }
