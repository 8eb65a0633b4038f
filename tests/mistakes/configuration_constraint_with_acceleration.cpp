// expect: configuration constraint 1 contains the rate of speed u; it may contain only coordinates
#include "pendulum.hpp"

struct System : bound_pendulum<configuration_constraints<s == l * dot(u)>> {};

int main() { use<System>(); }
