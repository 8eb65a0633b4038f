// expect: body Ball names itself Bob; the first template argument of its base must be Ball
#include "pendulum.hpp"

struct Ball : particle<Bob, P, m> {};

struct System : pendulum_with<Ball> {};

int main() { use<System>(); }
