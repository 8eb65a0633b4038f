// expect: point Q is fixed in A and is given a velocity of its own as well
#include "pendulum.hpp"

struct Q : offset<Q, O, l * A::x>, fixed_in<A>, velocity<N, u * A::y> {};
struct Ball : particle<Ball, Q, m> {};

struct System : pendulum_with<Ball> {};

int main() { use<System>(); }
