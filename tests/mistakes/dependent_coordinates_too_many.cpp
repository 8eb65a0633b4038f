// expect: 2 dependent coordinates for 1 configuration constraint; the numbers must be equal
#include "pendulum.hpp"

struct System : bound_pendulum<configuration_constraints<s == l * sin(q)>, dependent<q, s>> {};

int main() { use<System>(); }
