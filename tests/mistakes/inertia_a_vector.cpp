// expect: the inertia of Rod is a vector; it must be a dyadic: I*outer(A::x, A::x)
#include "pendulum.hpp"

struct Rod : rigid_body<Rod, P, A, m, inertia_dyadic<m * l * l * A::z>> {};

struct System : pendulum_with<Rod> {};

int main() { use<System>(); }
