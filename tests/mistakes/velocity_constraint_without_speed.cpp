// expect: velocity constraint 2 contains no speed
#include "pendulum.hpp"

struct System : bound_pendulum<velocity_constraints<u == v, l == 1>> {};

int main() { use<System>(); }
