// expect: configuration constraint 2 does not follow from the others; redundant<2> must not drop it
#include "pendulum.hpp"

struct System : bound_pendulum<configuration_constraints<s == 2 * q, s * s == 1 - q>, redundant<2>> {};

int main() { use<System>(); }
