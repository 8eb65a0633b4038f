// expect: gravity acts on bodies, which a Lagrangian replaces; add their potential energy to the Lagrangian
#include "pendulum.hpp"

struct System : rates_of_pendulum<lagrangian<m * dot(q) * dot(q)>, loads<gravity<-g * N::y>>> {};

int main() { use_rates<System>(); }
