// expect: 2 dependent speeds for 1 constraint on the velocities: there must be as many
#include "pendulum.hpp"

struct System : bound_pendulum<velocity_constraints<u == v>, dependent<u, v>> {};

int main() { use<System>(); }
