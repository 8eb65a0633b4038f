// expect: frame B is oriented relative to itself
#include "pendulum.hpp"

struct B;
struct C : rotated<C, B, q, N::z> {};
struct B : rotated<B, C, q, N::z> {};
struct Rod : rigid_body<Rod, P, B, m, inertia<A, 0, m * l * l, m * l * l>> {};

struct System : pendulum_with<Rod> {};

int main() { use<System>(); }
