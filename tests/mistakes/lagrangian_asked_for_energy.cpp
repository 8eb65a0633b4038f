// expect: energies, momenta, the mass center and the regressor require bodies; a system given by a Lagrangian
// expect: has none
#include "pendulum.hpp"

struct System : rates_of_pendulum<lagrangian<m * dot(q) * dot(q)>> {};
using eom = equations_of_motion<System>;

int main() { eom::kinetic_energy(eom::state(), eom::parameters()); }
