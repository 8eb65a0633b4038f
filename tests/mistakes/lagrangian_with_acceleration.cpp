// expect: the Lagrangian contains the second derivative of coordinate q
#include "pendulum.hpp"

struct System : rates_of_pendulum<lagrangian<m * dot(q) * dot(q) + dot(acceleration_of<P>, N::x)>> {};

int main() { use_rates<System>(); }
