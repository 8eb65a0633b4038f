// expect: point Q has two positions
#include "pendulum.hpp"

struct Q : offset<Q, O, l * A::x>, origin<Q, N> {};
struct Bead : particle<Bead, Q, m> {};

struct System : pendulum_with<Bead> {};

int main() { use<System>(); }
