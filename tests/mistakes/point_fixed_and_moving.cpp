// expect: point Q is fixed in A, but also has a declared velocity
#include "pendulum.hpp"

struct Q : offset<Q, O, l * A::x>, fixed_in<A>, velocity<N, u * A::y> {};
struct Ball : particle<Ball, Q, m> {};

struct System : pendulum_with<Ball> {};

int main() { use<System>(); }
