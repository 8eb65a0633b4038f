// expect: the mass of Ball is negative
#include "pendulum.hpp"

struct Ball : particle<Ball, P, -2.5> {};

struct System : pendulum_with<Ball> {};

int main() { use<System>(); }
