// expect: the quaternion of frame B does not have unit length
#include "pendulum.hpp"

struct B : quaternion<B, A, 1, 0, 0, 1> {};
struct Rod : rigid_body<Rod, P, B, m, inertia<B, 0, m * l * l, m * l * l>> {};

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Rod>> {};

int main() { use<System>(); }
