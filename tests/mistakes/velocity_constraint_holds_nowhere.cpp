// expect: velocity constraint 1 holds for no speeds
#include "pendulum.hpp"

struct System : bound_pendulum<velocity_constraints<u * u + v * v == -1>> {};

int main() { use<System>(); }
