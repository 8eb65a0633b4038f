// expect: configuration constraint 1 holds the rate of speed u; it may hold coordinates only
#include "pendulum.hpp"

struct System : bound_pendulum<configuration_constraints<s == l * dot(u)>> {};

int main() { use<System>(); }
