// expect: configuration constraint 1 contains no coordinate
#include "pendulum.hpp"

struct System : bound_pendulum<configuration_constraints<l == 1>> {};

int main() { use<System>(); }
