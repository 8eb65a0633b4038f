// expect: point Q is said to be fixed in A and to have a velocity of its own
#include "pendulum.hpp"

struct Q : offset<Q, O, l * A::x>, fixed_in<A>, velocity<N, u * A::y> {};
struct Ball : particle<Ball, Q, m> {};

struct System : pendulum_with<Ball> {};

int main() { use<System>(); }
