// expect: frame B has two angular velocities
#include "pendulum.hpp"

struct B : rotated<B, N, q, N::z>, angular_velocity<N, u * N::z>, angular_velocity<N, 2 * u * N::z> {};
struct Rod : rigid_body<Rod, P, B, m, inertia<B, 0, 1, 1>> {};

struct System : pendulum_with<Rod> {};

int main() { use<System>(); }
