// expect: frame N is among the words of System; write inertial<N>
#include "pendulum.hpp"

struct System : kane_system<N, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>> {};

int main() { use<System>(); }
