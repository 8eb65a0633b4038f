// expect: configuration constraint 1 holds the input T, whose rate is not known; make it prescribed, with its
// expect: rates among the inputs
#include "pendulum.hpp"

struct System : bound_pendulum<configuration_constraints<s == l * sin(q) + T>> {};

int main() { use<System>(); }
