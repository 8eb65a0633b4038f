// expect: two parameters are called k1
#include "pendulum.hpp"

constexpr parameter<"k", 1> k;
constexpr parameter<"k1"> other;
struct Bead : particle<Bead, P, k + other> {};

struct System : pendulum_with<Bead> {};

int main() { use<System>(); }
