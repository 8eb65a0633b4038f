// expect: configuration constraint 1 contains the speed u; it may contain only coordinates
#include "pendulum.hpp"

struct System : bound_pendulum<configuration_constraints<s == l * u>> {};

int main() { use<System>(); }
