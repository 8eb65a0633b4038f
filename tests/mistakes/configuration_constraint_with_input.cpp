// expect: configuration constraint 1 contains the input T, whose rate is not known; declare it prescribed and
// expect: list its rates among the inputs
#include "pendulum.hpp"

struct System : bound_pendulum<configuration_constraints<s == l * sin(q) + T>> {};

int main() { use<System>(); }
