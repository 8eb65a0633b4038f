// expect: the angular velocity of frame B is given relative to C, which turns with B
#include "pendulum.hpp"

struct C;
struct B : rotated<B, N, q, N::z>, angular_velocity<C, u * N::z> {};
struct C : rotated<C, B, q, N::z> {};
struct Rod : rigid_body<Rod, P, B, m, inertia<A, 0, m * l * l, m * l * l>> {};

struct System : pendulum_with<Rod> {};

int main() { use<System>(); }
