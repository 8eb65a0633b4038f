// expect: frame B calls itself A; the first argument of what it is derived from must be B
#include "pendulum.hpp"

struct B : rotated<A, N, q, N::z> {};
struct Rod : rigid_body<Rod, P, B, m, inertia<A, 0, m * l * l, m * l * l>> {};

struct System : pendulum_with<Rod> {};

int main() { use<System>(); }
