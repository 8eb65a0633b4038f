// expect: the offset of point Q contains a division by zero
#include "pendulum.hpp"

struct Q : offset<Q, O, l / 0 * A::x> {};
struct Ball : particle<Ball, Q, m> {};

struct System : pendulum_with<Ball> {};

int main() { use<System>(); }
