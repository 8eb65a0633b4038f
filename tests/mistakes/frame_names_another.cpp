// expect: frame B names itself A; the first template argument of its base must be B
#include "pendulum.hpp"

struct B : rotated<A, N, q, N::z> {};
struct Rod : rigid_body<Rod, P, B, m, inertia<A, 0, m * l * l, m * l * l>> {};

struct System : pendulum_with<Rod> {};

int main() { use<System>(); }
