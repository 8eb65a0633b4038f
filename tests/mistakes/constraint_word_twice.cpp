// expect: the system System lists velocity_constraints<...> twice; write one list
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            velocity_constraints<u == 0>, velocity_constraints<2 * u == 0>> {};

int main() { use<System>(); }
