// expect: configuration constraint 1 contains the input theta, whose second derivative is not known
#include "pendulum.hpp"

constexpr prescribed<"theta"> theta;

struct System
    : bound_pendulum<configuration_constraints<s == l * sin(q + theta)>, inputs<theta, dot(theta)>> {};

int main() { use<System>(); }
