// expect: the angle of frame B contains the speed u; it may contain only coordinates
#include "pendulum.hpp"

struct B : rotated<B, N, u, N::z> {};
struct Rod : rigid_body<Rod, P, B, m, inertia<A, 0, m * l * l, m * l * l>> {};

struct System : pendulum_with<Rod> {};

int main() { use<System>(); }
