// expect: the Lagrangian is a vector; it must be a scalar
#include "pendulum.hpp"

struct System : rates_of_pendulum<lagrangian<m * dot(q) * N::x>> {};

int main() { use_rates<System>(); }
