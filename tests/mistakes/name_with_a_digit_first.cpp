// expect: the name 2m does not begin with a letter
#include "pendulum.hpp"

constexpr parameter<"2m"> k;
struct Bead : particle<Bead, P, k> {};

struct System : pendulum_with<Bead> {};

int main() { use<System>(); }
