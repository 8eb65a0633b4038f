// expect: the inertia of Rod changes with coordinate q
#include "pendulum.hpp"

struct Rod : rigid_body<Rod, P, A, m, inertia<A, 0, m * q * q, m * q * q>> {};

struct System : pendulum_with<Rod> {};

int main() { use<System>(); }
