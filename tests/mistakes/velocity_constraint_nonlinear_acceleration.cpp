// expect: velocity constraint 1 contains the rate of speed u
#include "pendulum.hpp"

struct System : bound_pendulum<velocity_constraints<u * v == dot(u)>> {};

int main() { use<System>(); }
