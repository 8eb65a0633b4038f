// expect: velocity constraint 1 contradicts the rate of configuration constraint 1
#include "pendulum.hpp"

struct System : bound_pendulum<configuration_constraints<q == s>, velocity_constraints<u == v + 1>> {};

int main() { use<System>(); }
