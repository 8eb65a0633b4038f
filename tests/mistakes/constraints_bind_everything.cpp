// expect: the constraints determine every speed, so nothing can move
#include "pendulum.hpp"

struct System : bound_pendulum<configuration_constraints<q == 0>, velocity_constraints<u == v>> {};

int main() { use<System>(); }
