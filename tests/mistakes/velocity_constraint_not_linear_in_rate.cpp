// expect: velocity constraint 1 is not linear in the rate of coordinate q
#include "pendulum.hpp"

struct System : bound_pendulum<velocity_constraints<dot(q) * dot(q) == v>> {};

int main() { use<System>(); }
