// expect: body Bead is described twice
#include "pendulum.hpp"

struct Bead : particle<Bead, P, m>, rigid_body<Bead, P, A, m, inertia<A, 1, 1, 1>> {};

struct System : pendulum_with<Bead> {};

int main() { use<System>(); }
