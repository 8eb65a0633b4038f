// expect: v is listed twice among the auxiliary speeds
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            auxiliary<v, v>> {};

int main() { use<System>(); }
