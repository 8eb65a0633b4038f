// expect: the force at P contains the speed u; the only speeds of a lagrange_system are the rates of its
// expect: coordinates
#include "pendulum.hpp"

struct System : rates_of_pendulum<bodies<Bob>, loads<force<P, u * N::x>>> {};

int main() { use_rates<System>(); }
