// expect: frame B is rotated about an axis that is not fixed in N
#include "pendulum.hpp"

struct B : rotated<B, N, q, A::x> {};
struct Rod : rigid_body<Rod, P, B, m, inertia<A, 0, m * l * l, m * l * l>> {};

struct System : pendulum_with<Rod> {};

int main() { use<System>(); }
