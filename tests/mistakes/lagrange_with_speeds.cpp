// expect: the system System has speeds<...>; the only speeds of a lagrange_system are the rates of its
// expect: coordinates
#include "pendulum.hpp"

struct System : rates_of_pendulum<bodies<Bob>, speeds<u>> {};

int main() { use_rates<System>(); }
