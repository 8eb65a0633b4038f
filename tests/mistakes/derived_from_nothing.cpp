// expect: this system, or an entity in it, has no base class
#include "pendulum.hpp"

struct System {};

int main() { use<System>(); }
