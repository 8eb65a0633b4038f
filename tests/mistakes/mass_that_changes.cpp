// expect: the mass of Ball depends on the speed u
#include "pendulum.hpp"

struct Ball : particle<Ball, P, m * u> {};

struct System : pendulum_with<Ball> {};

int main() { use<System>(); }
