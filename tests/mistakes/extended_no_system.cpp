// expect: System extends Bob, which is not a system; extended<System, ...> takes a system and the words to
// expect: add
#include "pendulum.hpp"

struct System : extended<Bob, loads<weight>> {};

int main() { use<System>(); }
