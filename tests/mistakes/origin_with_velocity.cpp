// expect: point Q is an origin, fixed in the inertial frame, but has a declared motion
#include "pendulum.hpp"

struct Q : origin<Q, N>, velocity<N, u * N::x> {};
struct R : offset<R, Q, l * A::x> {};
struct Bead : particle<Bead, R, m> {};

struct System : pendulum_with<Bead> {};

int main() { use<System>(); }
