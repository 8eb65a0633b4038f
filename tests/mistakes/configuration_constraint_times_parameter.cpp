// expect: configuration constraint 2 follows from the preceding ones in every configuration
#include "pendulum.hpp"

struct System : bound_pendulum<configuration_constraints<s == l * sin(q), m * s == (m * l) * sin(q)>> {};

int main() { use<System>(); }
