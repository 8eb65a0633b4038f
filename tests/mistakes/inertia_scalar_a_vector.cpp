// expect: an inertia scalar of Rod is a vector; it must be a scalar
#include "pendulum.hpp"

struct Rod : rigid_body<Rod, P, A, m, inertia<A, 0, A::y, A::z>> {};

struct System : pendulum_with<Rod> {};

int main() { use<System>(); }
