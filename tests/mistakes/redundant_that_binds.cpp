// expect: configuration constraint 2 does not follow from the others, so it is not redundant; remove
// expect: redundant<2>
#include "pendulum.hpp"

struct System : bound_pendulum<configuration_constraints<s == 2 * q, s * s == 1 - q>, redundant<2>> {};

int main() { use<System>(); }
