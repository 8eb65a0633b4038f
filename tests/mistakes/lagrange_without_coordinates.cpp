// expect: the system System is told no coordinates<...>
#include "pendulum.hpp"

struct System : lagrange_system<inertial<N>, bodies<Bob>> {};

int main() { use_rates<System>(); }
