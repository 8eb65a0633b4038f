// expect: the offset of point Q adds a scalar and a vector
#include "pendulum.hpp"

struct Q : offset<Q, O, l + A::x> {};
struct Ball : particle<Ball, Q, m> {};

struct System : pendulum_with<Ball> {};

int main() { use<System>(); }
