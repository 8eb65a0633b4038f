// expect: frame M, which B uses, is not connected to the inertial frame N
#include "pendulum.hpp"

struct M : inertial_frame<M> {}; // another one
struct B : rotated<B, M, q, M::z> {};
struct Rod : rigid_body<Rod, P, B, m, inertia<A, 0, m * l * l, m * l * l>> {};

struct System : pendulum_with<Rod> {};

int main() { use<System>(); }
