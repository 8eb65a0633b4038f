// expect: bodies<...> lists P, which is a point; points need not be listed
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<P>> {};

int main() { use<System>(); }
