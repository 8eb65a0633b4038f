// expect: a derivative of the Lagrangian with respect to a rate contains the input T, whose rate is not known
#include "pendulum.hpp"

struct System : rates_of_pendulum<lagrangian<m * dot(q) * dot(q) + T * dot(q)>> {};

int main() { use_rates<System>(); }
