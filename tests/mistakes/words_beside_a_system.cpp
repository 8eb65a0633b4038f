// expect: a word is a separate base class of System; list it among the words of the system, between its < >
#include "pendulum.hpp"

struct System : pendulum_with<Bob>, loads<weight>, values<m == 2> {};

int main() { use<System>(); }
