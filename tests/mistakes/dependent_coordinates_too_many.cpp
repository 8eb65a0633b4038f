// expect: 2 dependent coordinates for 1 configuration constraint: there must be as many
#include "pendulum.hpp"

struct System : bound_pendulum<configuration_constraints<s == l * sin(q)>, dependent<q, s>> {};

int main() { use<System>(); }
