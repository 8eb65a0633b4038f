// expect: configuration constraint 1 constrains no coordinate in any configuration
#include "pendulum.hpp"

struct System : bound_pendulum<configuration_constraints<sign(q) == 1>> {};

int main() { use<System>(); }
