// expect: the mass of Ball contains the input T, whose rate is not known
#include "pendulum.hpp"

struct Ball : particle<Ball, P, m * T> {};

struct System : pendulum_with<Ball> {};

int main() { use<System>(); }
