// expect: velocity constraint 1 contains the input theta, whose rate is not known
#include "pendulum.hpp"

constexpr prescribed<"theta"> theta;

struct System : bound_pendulum<velocity_constraints<u == theta>, inputs<theta>> {};

int main() { use<System>(); }
