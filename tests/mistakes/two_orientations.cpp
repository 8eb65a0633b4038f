// expect: frame B has two orientations
#include "pendulum.hpp"

struct B : rotated<B, N, q, N::z>, rotated<B, N, 2 * q, N::z> {};
struct Rod : rigid_body<Rod, P, B, m, inertia<A, 0, 1, 1>> {};

struct System : pendulum_with<Rod> {};

int main() { use<System>(); }
