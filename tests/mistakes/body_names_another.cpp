// expect: body Ball calls itself Bob; the first argument of what it is derived from must be Ball
#include "pendulum.hpp"

struct Ball : particle<Bob, P, m> {};

struct System : pendulum_with<Ball> {};

int main() { use<System>(); }
