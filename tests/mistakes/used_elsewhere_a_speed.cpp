// expect: used_elsewhere<...> contains something that is neither a parameter nor an input, involving u
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            used_elsewhere<u>> {};

int main() { use<System>(); }
