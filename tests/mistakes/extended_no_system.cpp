// expect: System extends Bob, which is not a system; extended<System, ...> takes one and what is added to it
#include "pendulum.hpp"

struct System : extended<Bob, loads<weight>> {};

int main() { use<System>(); }
