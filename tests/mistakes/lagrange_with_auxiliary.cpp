// expect: the system System has auxiliary<...>; a lagrange_system has no speeds but the rates of its
// coordinates
#include "pendulum.hpp"

struct System : rates_of_pendulum<bodies<Bob>, auxiliary<v>> {};

int main() { use_rates<System>(); }
