// expect: the Lagrangian multiplies a vector by a vector; write dot, cross or outer
#include "pendulum.hpp"

struct System : rates_of_pendulum<lagrangian<m * velocity_of<P> * velocity_of<P> / 2>> {};

int main() { use_rates<System>(); }
