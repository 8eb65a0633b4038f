// expect: there are 3 constraints on the velocities for 2 speeds
#include "pendulum.hpp"

struct System : bound_pendulum<velocity_constraints<u == 0, v == 0, u == v>> {};

int main() { use<System>(); }
