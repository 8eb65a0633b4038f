// expect: the constraints determine every speed, so nothing can move; where all hold, configuration
// expect: constraint 2 follows from the preceding ones; add redundant<2> to drop it
#include "pendulum.hpp"

struct System : bound_pendulum<configuration_constraints<q == s, q * q == s * s>> {};

int main() { use<System>(); }
