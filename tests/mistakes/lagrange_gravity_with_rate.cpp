// expect: gravity contains the rate of coordinate q; it may contain only parameters, inputs and time
#include "pendulum.hpp"

struct System : rates_of_pendulum<bodies<Bob>, loads<gravity<-g * dot(q) * N::y>>> {};

int main() { use_rates<System>(); }
