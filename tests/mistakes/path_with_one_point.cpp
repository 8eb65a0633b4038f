// expect: the pathway of the linear damper lacks an argument; write straight<Point, Other>
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<linear_damper<straight<P>, 3>>> {};

int main() { use<System>(); }
