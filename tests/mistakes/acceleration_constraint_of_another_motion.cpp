// expect: acceleration constraint 1 does not follow from the constraints on the velocities
#include "pendulum.hpp"

struct System : bound_pendulum<velocity_constraints<u == v>, acceleration_constraints<dot(u) == 2 * dot(v)>> {
};

int main() { use<System>(); }
