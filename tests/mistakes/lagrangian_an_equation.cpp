// expect: the Lagrangian is an equation; it must be a scalar
#include "pendulum.hpp"

struct System : rates_of_pendulum<lagrangian<m * dot(q) == l>> {};

int main() { use_rates<System>(); }
