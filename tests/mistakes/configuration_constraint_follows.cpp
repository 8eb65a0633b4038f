// expect: configuration constraint 2 follows from the preceding ones in every configuration
#include "pendulum.hpp"

struct System : bound_pendulum<configuration_constraints<s == l * q, 2 * s == 2 * (l * q)>> {};

int main() { use<System>(); }
