// expect: point Q is offset from itself
#include "pendulum.hpp"

struct Q : offset<Q, Q, l * A::x> {};
struct Ball : particle<Ball, Q, m> {};

struct System : pendulum_with<Ball> {};

int main() { use<System>(); }
