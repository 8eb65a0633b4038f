// expect: fixed_in<...> stands beside Bead, which is not a point
#include "pendulum.hpp"

struct Bead : particle<Bead, P, m>, fixed_in<A> {};

struct System : pendulum_with<Bead> {};

int main() { use<System>(); }
