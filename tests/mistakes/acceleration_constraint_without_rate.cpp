// expect: acceleration constraint 1 contains no rate of a speed
#include "pendulum.hpp"

struct System : bound_pendulum<velocity_constraints<u == v>, acceleration_constraints<u == v>> {};

int main() { use<System>(); }
