// expect: configuration constraint 1 holds the input T, whose rate is not known
#include "pendulum.hpp"

struct System : bound_pendulum<configuration_constraints<s == l * sin(q) + T>> {};

int main() { use<System>(); }
