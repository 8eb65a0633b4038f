// expect: a word is a separate base class of System; write it among the words, between the < > of the system
#include "pendulum.hpp"

struct System : pendulum_with<Bob>, loads<weight>, values<m == 2> {};

int main() { use<System>(); }
