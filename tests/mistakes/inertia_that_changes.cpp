// expect: the inertia of Rod depends on the rate of coordinate q
#include "pendulum.hpp"

struct Rod : rigid_body<Rod, P, A, m, inertia<A, 0, m * l * dot(q), m * l * dot(q)>> {};

struct System : pendulum_with<Rod> {};

int main() { use<System>(); }
