// expect: the velocity of point Q is not linear in the speed u
#include "pendulum.hpp"

struct Q : offset<Q, O, l * A::x>, velocity<N, l * u * u * A::y> {};
struct Ball : particle<Ball, Q, m> {};

struct System : pendulum_with<Ball> {};

int main() { use<System>(); }
