// expect: the system System lists loads<...> twice; write one list
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<weight>, loads<torque<A, T * N::z>>> {};

int main() { use<System>(); }
