// expect: 2 acceleration constraints for 1 constraint on the velocities; the numbers must be equal
#include "pendulum.hpp"

struct System
    : bound_pendulum<velocity_constraints<u == v>, acceleration_constraints<dot(u) == dot(v), dot(u) == 0>> {
};

int main() { use<System>(); }
