// expect: velocity constraint 1 is not linear in the speed u
#include "pendulum.hpp"

struct System : bound_pendulum<velocity_constraints<u * v == 0>> {};

int main() { use<System>(); }
