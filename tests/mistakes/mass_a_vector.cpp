// expect: the mass of Ball is a vector; it must be a scalar
#include "pendulum.hpp"

struct Ball : particle<Ball, P, m * N::x> {};

struct System : pendulum_with<Ball> {};

int main() { use<System>(); }
