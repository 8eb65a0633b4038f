// expect: fixed_in<...> is a base class of Bead, which is not a point
#include "pendulum.hpp"

struct Bead : particle<Bead, P, m>, fixed_in<A> {};

struct System : pendulum_with<Bead> {};

int main() { use<System>(); }
