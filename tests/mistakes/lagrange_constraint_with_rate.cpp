// expect: configuration constraint 1 contains the rate of coordinate s; it may contain only coordinates
#include "pendulum.hpp"

struct System : rates_of_both<bodies<Bob, Block>, configuration_constraints<dot(s) == l>> {};

int main() { use_rates<System>(); }
