// expect: an inertia is a base class of Bead; it belongs in rigid_body<...>
#include "pendulum.hpp"

struct Bead : particle<Bead, P, m>, inertia<A, 0, 1, 1> {};

struct System : pendulum_with<Bead> {};

int main() { use<System>(); }
