// expect: the name u is used twice: among the speeds and among the auxiliary speeds
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            auxiliary<u>> {};

int main() { use<System>(); }
