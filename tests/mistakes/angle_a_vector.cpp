// expect: the angle of frame B is a vector; it must be a scalar
#include "pendulum.hpp"

struct B : rotated<B, N, N::z, q> {}; // in the wrong order
struct Rod : rigid_body<Rod, P, B, m, inertia<A, 0, m * l * l, m * l * l>> {};

struct System : pendulum_with<Rod> {};

int main() { use<System>(); }
