// expect: kinematics<...> contains something that is not an equation, involving P; write dot(q) == u
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>,
                            kinematics<zero_along<velocity_of<P>, N::x>>, bodies<Bob>> {};

int main() { use<System>(); }
