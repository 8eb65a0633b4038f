// expect: the value of parameter g contains a number that is not finite
#include "pendulum.hpp"

#include <limits>

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<weight>, values<g == std::numeric_limits<double>::quiet_NaN()>> {};

int main() { use<System>(); }
