// expect: acceleration constraint 1 is not the time derivative of the constraints on the velocities
#include "pendulum.hpp"

struct System
    : bound_pendulum<velocity_constraints<u == q * v>, acceleration_constraints<dot(u) == q * dot(v)>> {};

int main() { use<System>(); }
