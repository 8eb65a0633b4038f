// expect: point Q has two velocities
#include "pendulum.hpp"

struct Q : offset<Q, O, l * A::x>, velocity<N, u * l * A::y>, velocity<A, 0.0 * A::x> {};
struct Bead : particle<Bead, Q, m> {};

struct System : pendulum_with<Bead> {};

int main() { use<System>(); }
