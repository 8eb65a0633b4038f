// expect: the system System has bodies<...> and lagrangian<...>; a Lagrangian contains the energy of all
// expect: bodies
#include "pendulum.hpp"

struct System : rates_of_pendulum<bodies<Bob>, lagrangian<m * dot(q) * dot(q)>> {};

int main() { use_rates<System>(); }
