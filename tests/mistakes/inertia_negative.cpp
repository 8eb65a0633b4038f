// expect: a moment of inertia of Rod is negative
#include "pendulum.hpp"

struct Rod : rigid_body<Rod, P, A, m, inertia<A, 1, -1, 1>> {};

struct System : pendulum_with<Rod> {};

int main() { use<System>(); }
