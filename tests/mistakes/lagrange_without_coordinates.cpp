// expect: the system System has no coordinates<...>
#include "pendulum.hpp"

struct System : lagrange_system<inertial<N>, bodies<Bob>> {};

int main() { use_rates<System>(); }
