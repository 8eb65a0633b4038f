// expect: dependent<...> contains something that is neither a coordinate nor a speed
#include "pendulum.hpp"

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            velocity_constraints<u == 0>, dependent<1>> {};

int main() { use<System>(); }
