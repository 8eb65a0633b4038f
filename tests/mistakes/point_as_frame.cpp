// expect: O, which B uses as a frame, is a point
#include "pendulum.hpp"

struct B : rotated<B, O, q, N::z> {};
struct Rod : rigid_body<Rod, P, B, m, inertia<A, 0, m * l * l, m * l * l>> {};

struct System : pendulum_with<Rod> {};

int main() { use<System>(); }
