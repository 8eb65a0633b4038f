// expect: 2 dependent speeds for 1 constraint on the velocities; the numbers must be equal
#include "pendulum.hpp"

struct System : bound_pendulum<velocity_constraints<u == v>, dependent<u, v>> {};

int main() { use<System>(); }
