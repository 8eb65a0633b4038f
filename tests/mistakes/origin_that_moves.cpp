// expect: origin Q is not fixed in the inertial frame; a point that moves needs an offset
#include "pendulum.hpp"

struct Q : origin<Q, A> {};
struct Ball : particle<Ball, Q, m> {};

struct System : pendulum_with<Ball> {};

int main() { use<System>(); }
