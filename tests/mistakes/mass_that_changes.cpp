// expect: the mass of Ball changes with coordinate q
#include "pendulum.hpp"

struct Ball : particle<Ball, P, m * q> {};

struct System : pendulum_with<Ball> {};

int main() { use<System>(); }
