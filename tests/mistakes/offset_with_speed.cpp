// expect: the offset of point Q holds the speed u; it may hold coordinates only
#include "pendulum.hpp"

struct Q : offset<Q, O, u * A::x> {};
struct Ball : particle<Ball, Q, m> {};

struct System : pendulum_with<Ball> {};

int main() { use<System>(); }
