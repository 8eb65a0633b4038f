// expect: the offset of point Q contains the speed u; it may contain only coordinates
#include "pendulum.hpp"

struct Q : offset<Q, O, u * A::x> {};
struct Ball : particle<Ball, Q, m> {};

struct System : pendulum_with<Ball> {};

int main() { use<System>(); }
