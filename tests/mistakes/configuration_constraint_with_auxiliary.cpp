// expect: configuration constraint 1 contains the auxiliary speed w; it may contain only coordinates
#include "pendulum.hpp"

constexpr speed<"w"> w;

struct System : bound_pendulum<configuration_constraints<s == l * w>, auxiliary<w>> {};

int main() { use<System>(); }
