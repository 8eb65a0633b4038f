// expect: velocity constraint 1 constrains no speed in any configuration
#include "pendulum.hpp"

struct System : bound_pendulum<velocity_constraints<(sign(q * q + 1) - 1) * u == 0>> {};

int main() { use<System>(); }
