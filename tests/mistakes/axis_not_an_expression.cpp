// expect: the axis of frame B is not an expression; it must be a vector
#include "pendulum.hpp"

struct B : rotated<B, N, q, nullptr> {};
struct Rod : rigid_body<Rod, P, B, m, inertia<A, 0, m * l * l, m * l * l>> {};

struct System : pendulum_with<Rod> {};

int main() { use<System>(); }
