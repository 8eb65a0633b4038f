// expect: loads<...> stands beside the words of System; write it among them, between the < > of its system
#include "pendulum.hpp"

struct System : pendulum_with<Bob>, loads<weight> {};

int main() { use<System>(); }
