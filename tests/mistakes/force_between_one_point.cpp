// expect: a force acts between point P and itself
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<force_between<P, P, T * N::x>>> {};

int main() { use<System>(); }
