// expect: gravity acts on bodies, and a Lagrangian takes their place; it holds their potential energy
#include "pendulum.hpp"

struct System : rates_of_pendulum<lagrangian<m * dot(q) * dot(q)>, loads<gravity<-g * N::y>>> {};

int main() { use_rates<System>(); }
