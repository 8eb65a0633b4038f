// expect: a word is a separate base class of System; list it with the other words of the system, inside its <
// expect: >
#include "pendulum.hpp"

struct System : pendulum_with<Bob>, loads<weight>, values<m == 2> {};

int main() { use<System>(); }
