// expect: frame B is rotated about an axis of zero length
#include "pendulum.hpp"

struct B : rotated<B, N, q, N::z - N::z> {};
struct Rod : rigid_body<Rod, P, B, m, inertia<A, 0, m * l * l, m * l * l>> {};

struct System : pendulum_with<Rod> {};

int main() { use<System>(); }
