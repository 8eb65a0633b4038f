// expect: loads<...> is a separate base class of System; list it with the other words of the system, inside
// expect: its < >
#include "pendulum.hpp"

struct System : pendulum_with<Bob>, loads<weight> {};

int main() { use<System>(); }
