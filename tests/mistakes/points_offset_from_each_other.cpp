// expect: point R is offset from itself
#include "pendulum.hpp"

struct Q;
struct R : offset<R, Q, l * A::x> {};
struct Q : offset<Q, R, l * A::x> {};
struct Ball : particle<Ball, R, m> {};

struct System : pendulum_with<Ball> {};

int main() { use<System>(); }
