// expect: the offset of point Q multiplies a vector by a vector; write dot, cross or outer
#include "pendulum.hpp"

struct Q : offset<Q, O, A::x * A::y * A::x> {};
struct Ball : particle<Ball, Q, m> {};

struct System : pendulum_with<Ball> {};

int main() { use<System>(); }
