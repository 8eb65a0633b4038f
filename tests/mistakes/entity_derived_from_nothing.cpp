// expect: this system, or an entity in it, has no base class
#include "pendulum.hpp"

struct B {};
struct Rod : rigid_body<Rod, P, B, m, inertia<B, m, m, m>> {};
struct System : pendulum_with<Rod> {};

int main() { use<System>(); }
