// expect: the system System has neither bodies<...> nor lagrangian<...>
#include "pendulum.hpp"

struct System : rates_of_pendulum<loads<weight>> {};

int main() { use_rates<System>(); }
