// expect: velocity<...> is a base class of B, which is not a point
#include "pendulum.hpp"

struct B : rotated<B, N, q, N::z>, velocity<N, u * N::z> {};
struct Rod : rigid_body<Rod, P, B, m, inertia<B, 0, 1, 1>> {};

struct System : pendulum_with<Rod> {};

int main() { use<System>(); }
