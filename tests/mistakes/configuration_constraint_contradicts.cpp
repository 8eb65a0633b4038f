// expect: configuration constraint 2 contradicts the preceding ones
#include "pendulum.hpp"

struct System : bound_pendulum<configuration_constraints<q == s, q == s + 1>> {};

int main() { use<System>(); }
