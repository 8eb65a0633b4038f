// expect: the name t is used twice: among the symbols for the time and among the parameters
#include "pendulum.hpp"

constexpr parameter<"t"> thick;
struct Bead : particle<Bead, P, m + t * thick> {};

struct System : pendulum_with<Bead> {};

int main() { use<System>(); }
