// expect: dependent speed v appears in no constraint
#include "pendulum.hpp"

struct System : bound_pendulum<velocity_constraints<u == 0>, dependent<v>> {};

int main() { use<System>(); }
