// expect: the offset of point Q contains the input T, whose rate is not known
#include "pendulum.hpp"

struct Q : offset<Q, O, T * A::x> {};
struct Ball : particle<Ball, Q, m> {};

struct System : pendulum_with<Ball> {};

int main() { use<System>(); }
