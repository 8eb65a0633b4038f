// expect: the force at P contains the second derivative of coordinate q
#include "pendulum.hpp"

struct System : rates_of_pendulum<bodies<Bob>, loads<force<P, dot(dot(q)) * N::x>>> {};

int main() { use_rates<System>(); }
