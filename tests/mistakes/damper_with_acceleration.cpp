// expect: the damping between P and O contains the rate of speed u
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<damper<P, O, m * magnitude(acceleration_of<P>)>>> {};

int main() { use<System>(); }
