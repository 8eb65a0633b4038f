// expect: the force at P holds the speed u; a lagrange_system has no speeds but the rates of its coordinates
#include "pendulum.hpp"

struct System : rates_of_pendulum<bodies<Bob>, loads<force<P, u * N::x>>> {};

int main() { use_rates<System>(); }
