// expect: the Coriolis matrix requires a system without constraints
#include "pendulum.hpp"

struct System : bound_pendulum<velocity_constraints<u == v>> {};
using eom = equations_of_motion<System>;

int main() { eom::coriolis(eom::state(), eom::parameters()); }
