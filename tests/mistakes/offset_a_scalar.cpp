// expect: the offset of point Q is a scalar; it must be a vector
#include "pendulum.hpp"

struct Q : offset<Q, O, l> {};
struct Ball : particle<Ball, Q, m> {};

struct System : pendulum_with<Ball> {};

int main() { use<System>(); }
