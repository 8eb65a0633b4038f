// expect: velocity constraint 1 contains the input T, whose rate is not known
#include "pendulum.hpp"

struct System : bound_pendulum<velocity_constraints<u == T>> {};

int main() { use<System>(); }
