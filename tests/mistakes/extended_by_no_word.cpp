// expect: the force at P stands among the words of System; write loads<...> around it
#include "pendulum.hpp"

struct System : extended<pendulum_with<Bob>, weight> {};

int main() { use<System>(); }
