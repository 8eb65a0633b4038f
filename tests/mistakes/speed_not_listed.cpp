// expect: speed v, which the angular velocity of frame B contains, is not in the list of speeds
#include "pendulum.hpp"

struct B : rotated<B, N, q, N::z>, angular_velocity<N, v * N::z> {};
struct Rod : rigid_body<Rod, P, B, m, inertia<A, 0, m * l * l, m * l * l>> {};

struct System : pendulum_with<Rod> {};

int main() { use<System>(); }
