// expect: template
// The compiler's own error, about a value where a template takes a type. The library reports nothing about
// the consequences.
#include "pendulum.hpp"

struct Rod : rigid_body<Rod, P, A, m, m> {};
struct System : pendulum_with<Rod> {};

int main() { use<System>(); }
