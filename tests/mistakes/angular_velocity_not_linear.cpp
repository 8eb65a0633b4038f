// expect: the angular velocity of frame B is not linear in the speed u
#include "pendulum.hpp"

struct B : rotated<B, N, q, N::z>, angular_velocity<N, u * u * N::z> {};
struct Rod : rigid_body<Rod, P, B, m, inertia<A, 0, m * l * l, m * l * l>> {};

struct System : pendulum_with<Rod> {};

int main() { use<System>(); }
