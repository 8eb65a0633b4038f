// expect: body Ball has no mass
#include "pendulum.hpp"

struct Ball : particle<Ball, P, 0.0> {};

struct System : pendulum_with<Ball> {};

int main() { use<System>(); }
