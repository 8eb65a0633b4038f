// expect: dependent coordinate s appears in no configuration constraint
#include "pendulum.hpp"

struct System : bound_pendulum<configuration_constraints<sin(q) == 1>, dependent<s>> {};

int main() { use<System>(); }
