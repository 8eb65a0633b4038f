// expect: gravity holds the rate of coordinate q; it may hold parameters, inputs and time only
#include "pendulum.hpp"

struct System : rates_of_pendulum<bodies<Bob>, loads<gravity<-g * dot(q) * N::y>>> {};

int main() { use_rates<System>(); }
