// expect: the Coriolis matrix is that of a mass matrix which changes with the coordinates alone; this one
// changes expect: with the rate of coordinate q
#include "pendulum.hpp"

struct System : rates_of_pendulum<lagrangian<-m * sqrt(1 - dot(q) * dot(q))>> {};
using eom = equations_of_motion<System>;

int main() { eom::coriolis(eom::state(), eom::parameters()); }
