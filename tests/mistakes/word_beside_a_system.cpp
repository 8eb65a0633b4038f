// expect: loads<...> is a separate base class of System; write it among the words, between the < > of the
// expect: system
#include "pendulum.hpp"

struct System : pendulum_with<Bob>, loads<weight> {};

int main() { use<System>(); }
