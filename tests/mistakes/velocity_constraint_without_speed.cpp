// expect: velocity constraint 2 holds no speed
#include "pendulum.hpp"

struct System : bound_pendulum<velocity_constraints<u == v, l == q>> {};

int main() { use<System>(); }
