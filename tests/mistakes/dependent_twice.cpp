// expect: speed u is listed twice in dependent<...>
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            velocity_constraints<u == 0>, dependent<u, u>> {};

int main() { use<System>(); }
