// expect: auxiliary speed v is listed, but nothing in the system uses it
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, auxiliary<v>, kinematics<dot(q) == u>,
                            bodies<Bob>, loads<weight>> {};

int main() { use<System>(); }
