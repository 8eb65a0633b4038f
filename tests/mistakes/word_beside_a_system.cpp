// expect: loads<...> is a separate base class of System; list it among the words of the system, between
// expect: its < >
#include "pendulum.hpp"

struct System : pendulum_with<Bob>, loads<weight> {};

int main() { use<System>(); }
