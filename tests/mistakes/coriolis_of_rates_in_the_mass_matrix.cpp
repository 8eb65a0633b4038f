// expect: the Coriolis matrix requires a mass matrix that depends only on coordinates; this one depends on
// expect: the rate of coordinate q
#include "pendulum.hpp"

struct System : rates_of_pendulum<lagrangian<-m * sqrt(1 - dot(q) * dot(q))>> {};
using eom = equations_of_motion<System>;

int main() { eom::coriolis(eom::state(), eom::parameters()); }
