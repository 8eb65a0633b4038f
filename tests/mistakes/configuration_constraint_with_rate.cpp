// expect: configuration constraint 1 contains the rate of coordinate q; it may contain only coordinates
#include "pendulum.hpp"

struct System : bound_pendulum<configuration_constraints<s == l * dot(q)>> {};

int main() { use<System>(); }
