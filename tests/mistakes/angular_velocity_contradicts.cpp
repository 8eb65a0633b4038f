// expect: the angular velocity of frame B does not match its orientation, and no omitted angle explains the
// expect: difference; if this is intended, write angular_velocity_apart
#include "pendulum.hpp"

struct B : rotated<B, N, q, N::z>, angular_velocity<N, 2 * u * N::z> {};
struct Rod : rigid_body<Rod, P, B, m, inertia<B, 0, m * l * l, m * l * l>> {};

struct System : pendulum_with<Rod> {};

int main() { use<System>(); }
