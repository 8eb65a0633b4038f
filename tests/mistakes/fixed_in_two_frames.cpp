// expect: point Q is fixed in two frames
#include "pendulum.hpp"

struct Q : offset<Q, O, l * A::x>, fixed_in<A>, fixed_in<N> {};
struct Bead : particle<Bead, Q, m> {};

struct System : pendulum_with<Bead> {};

int main() { use<System>(); }
