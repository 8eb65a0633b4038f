// expect: the inertia of Rod is not symmetric
#include "pendulum.hpp"

struct Rod : rigid_body<Rod, P, A, m, inertia_dyadic<m * l * l * outer(A::x, A::y)>> {};

struct System : pendulum_with<Rod> {};

int main() { use<System>(); }
