// expect: velocity constraint 2 contradicts the preceding ones
#include "pendulum.hpp"

struct System : bound_pendulum<velocity_constraints<u == v, u == v + 1>> {};

int main() { use<System>(); }
