// expect: velocity constraint 2 follows from the preceding ones in every configuration
#include "pendulum.hpp"

struct System : bound_pendulum<velocity_constraints<u == v, 2 * u == 2 * v>> {};

int main() { use<System>(); }
