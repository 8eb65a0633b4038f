// expect: the direction cosines of frame B are not right-handed: they describe a reflection
#include "pendulum.hpp"

struct B : direction_cosines<B, A, 0.6, 0.8, 0, 0.8, -0.6, 0, 0, 0, 1> {};
struct Rod : rigid_body<Rod, P, B, m, inertia<B, 0, m * l * l, m * l * l>> {};

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Rod>> {};

int main() { use<System>(); }
