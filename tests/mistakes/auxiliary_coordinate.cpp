// expect: coordinate s is in the list of auxiliary speeds
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            auxiliary<s>> {};

int main() { use<System>(); }
