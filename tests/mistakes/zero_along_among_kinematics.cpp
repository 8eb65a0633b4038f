// expect: kinematics<...> holds something that is not an equation, with P; write dot(q) == u
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>,
                            kinematics<zero_along<velocity_of<P>, N::x>>, bodies<Bob>> {};

int main() { use<System>(); }
