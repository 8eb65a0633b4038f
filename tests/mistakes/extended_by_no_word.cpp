// expect: the force at P is among the words of System; list it in loads<...>
#include "pendulum.hpp"

struct System : extended<pendulum_with<Bob>, weight> {};

int main() { use<System>(); }
