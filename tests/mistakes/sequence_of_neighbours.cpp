// expect: frame B has an invalid rotation sequence; use three axes, no two consecutive ones equal: zxz
#include "pendulum.hpp"

struct B : body_fixed<B, N, "xxz", q, 0.0, 0.0> {};
struct Rod : rigid_body<Rod, P, B, m, inertia<A, 0, m * l * l, m * l * l>> {};

struct System : pendulum_with<Rod> {};

int main() { use<System>(); }
