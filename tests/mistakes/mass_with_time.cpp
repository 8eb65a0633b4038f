// expect: the mass of Ball changes with time t
#include "pendulum.hpp"

struct Ball : particle<Ball, P, m * t> {};

struct System : pendulum_with<Ball> {};

int main() { use<System>(); }
