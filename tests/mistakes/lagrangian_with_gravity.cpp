// expect: gravity acts on bodies, but a system given by a Lagrangian has none; add the potential energy of
// expect: gravity to the Lagrangian
#include "pendulum.hpp"

struct System : rates_of_pendulum<lagrangian<m * dot(q) * dot(q)>, loads<gravity<-g * N::y>>> {};

int main() { use_rates<System>(); }
