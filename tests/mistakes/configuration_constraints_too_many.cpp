// expect: there are 3 configuration constraints for 2 coordinates
#include "pendulum.hpp"

struct System : bound_pendulum<configuration_constraints<q == 0, s == 0, q == s>> {};

int main() { use<System>(); }
