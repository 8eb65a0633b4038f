// expect: point Q calls itself P; the first argument of what it is derived from must be Q
#include "pendulum.hpp"

struct Q : offset<P, O, l * A::x> {};
struct Ball : particle<Ball, Q, m> {};

struct System : pendulum_with<Ball> {};

int main() { use<System>(); }
