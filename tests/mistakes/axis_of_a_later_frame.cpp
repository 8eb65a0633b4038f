// expect: B, which Rod uses as a frame, is not a frame, or is defined later
#include "pendulum.hpp"

struct B;
struct C : rotated<C, B, q, N::z> {};
struct B : rotated<B, N, q, C::x> {};
struct Rod : rigid_body<Rod, P, B, m, inertia<A, 0, m * l * l, m * l * l>> {};

struct System : pendulum_with<Rod> {};

int main() { use<System>(); }
