// expect: energies, momenta, the mass centre and the regressor are those of bodies, and a Lagrangian takes
// their place
#include "pendulum.hpp"

struct System : rates_of_pendulum<lagrangian<m * dot(q) * dot(q)>> {};
using eom = equations_of_motion<System>;

int main() { eom::kinetic_energy(eom::state(), eom::parameters()); }
