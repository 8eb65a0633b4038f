// expect: this system, or an entity in it, is derived from nothing
#include "pendulum.hpp"

struct System {};

int main() { use<System>(); }
