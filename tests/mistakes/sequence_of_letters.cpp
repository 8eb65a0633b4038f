// expect: frame B is turned by an invalid sequence; take three axes, no two neighbours alike: zxz
#include "pendulum.hpp"

struct B : space_fixed<B, N, "xq", q, 0.0, 0.0> {};
struct Rod : rigid_body<Rod, P, B, m, inertia<A, 0, m * l * l, m * l * l>> {};

struct System : pendulum_with<Rod> {};

int main() { use<System>(); }
