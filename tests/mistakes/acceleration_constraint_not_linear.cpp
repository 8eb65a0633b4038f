// expect: acceleration constraint 1 is not linear in the rate of speed u
#include "pendulum.hpp"

struct System : bound_pendulum<velocity_constraints<u == v>, acceleration_constraints<dot(u) * dot(v) == 0>> {
};

int main() { use<System>(); }
