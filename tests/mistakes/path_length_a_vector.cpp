// expect: the length of the force with N is a vector; it must be a scalar
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<force_along<given_length<N::x>, T>>> {};

int main() { use<System>(); }
