// expect: the derivatives of velocity constraint 1 with respect to the speeds vanish wherever it holds
#include "pendulum.hpp"

struct System : bound_pendulum<velocity_constraints<u * u + v * v == 0>> {};

int main() { use<System>(); }
