// expect: configuration constraint 1 holds the rate of coordinate q; it may hold coordinates only
#include "pendulum.hpp"

struct System : bound_pendulum<configuration_constraints<s == l * dot(q)>> {};

int main() { use<System>(); }
