// expect: the damper between P and O is among the words of System; list it in loads<...>
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            damper<P, O, m>> {};

int main() { use<System>(); }
