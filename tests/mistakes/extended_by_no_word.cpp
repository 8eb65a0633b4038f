// expect: the force at P is among the words of System; write loads<...> around it
#include "pendulum.hpp"

struct System : extended<pendulum_with<Bob>, weight> {};

int main() { use<System>(); }
