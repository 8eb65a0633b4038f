// expect: inertia_forces needs the second derivative of coordinate q: call it as inertia_forces(x, p, r, a)
#include "pendulum.hpp"

struct System : rates_of_pendulum<bodies<Bob>> {};
using eom = equations_of_motion<System>;

int main() { eom::inertia_forces(eom::state(), eom::parameters(), eom::inputs()); }
