// expect: velocity constraint 2 holds no speed
#include "pendulum.hpp"

struct System : bound_pendulum<velocity_constraints<u == v, l == 1>> {};

int main() { use<System>(); }
