// expect: one of the parameters has no name
#include "pendulum.hpp"

constexpr parameter<""> k;
struct Bead : particle<Bead, P, k> {};

struct System : pendulum_with<Bead> {};

int main() { use<System>(); }
