// expect: A, which Rod uses as a point, is a frame
#include "pendulum.hpp"

struct Rod : rigid_body<Rod, A, A, m, inertia<A, 0, m * l * l, m * l * l>> {};

struct System : pendulum_with<Rod> {};

int main() { use<System>(); }
