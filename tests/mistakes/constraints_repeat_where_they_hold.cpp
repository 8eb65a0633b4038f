// expect: the constraints bind every speed: nothing is left that could move; where all hold, configuration
// expect: constraint 2 follows from those before it, and redundant<2> leaves it out
#include "pendulum.hpp"

struct System : bound_pendulum<configuration_constraints<q == s, q * q == s * s>> {};

int main() { use<System>(); }
