// expect: the Coriolis matrix requires every speed to be a coordinate rate; speed u is not one
#include "pendulum.hpp"

struct System
    : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == 2 * u>, bodies<Bob>> {};
using eom = equations_of_motion<System>;

int main() { eom::coriolis(eom::state(), eom::parameters()); }
