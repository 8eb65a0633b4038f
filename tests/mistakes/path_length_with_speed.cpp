// expect: the length of the force with q*u contains the speed u; it may contain only coordinates
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<force_along<given_length<q * u>, T>>> {};

int main() { use<System>(); }
