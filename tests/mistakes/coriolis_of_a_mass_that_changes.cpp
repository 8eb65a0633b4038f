// expect: the mass of Sponge depends on coordinate s; the Coriolis matrix requires constant masses and
// expect: inertias
#include "pendulum.hpp"

struct Sponge : particle<Sponge, S, m * (1 + s * s)> {};
struct System : kane_system<inertial<N>, coordinates<s>, speeds<v>, kinematics<dot(s) == v>, bodies<Sponge>> {
};
using eom = equations_of_motion<System>;

int main() { eom::coriolis(eom::state(), eom::parameters()); }
