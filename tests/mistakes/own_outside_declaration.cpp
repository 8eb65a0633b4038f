// expect: the offset of point Q contains own::x, which is valid only in the declared angular velocity of a
// expect: frame; write N::x
#include "pendulum.hpp"

struct Q : offset<Q, O, l * own::x> {};
struct Ball : particle<Ball, Q, m> {};

struct System : pendulum_with<Ball> {};

int main() { use<System>(); }
