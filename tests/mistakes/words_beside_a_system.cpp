// expect: a word stands beside the words of System; write it among them, between the < > of its system
#include "pendulum.hpp"

struct System : pendulum_with<Bob>, loads<weight>, values<m == 2> {};

int main() { use<System>(); }
