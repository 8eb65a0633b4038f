// expect: the inertial frame is said to be A, which stands in N
#include "pendulum.hpp"

struct System : kane_system<inertial<A>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>> {};

int main() { use<System>(); }
