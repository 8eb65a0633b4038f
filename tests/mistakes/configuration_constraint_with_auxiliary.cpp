// expect: configuration constraint 1 holds the auxiliary speed w; it may hold coordinates only
#include "pendulum.hpp"

constexpr speed<"w"> w;

struct System : bound_pendulum<configuration_constraints<s == l * w>, auxiliary<w>> {};

int main() { use<System>(); }
