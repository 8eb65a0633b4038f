// expect: configuration constraint 1 holds the rate of coordinate s; it may hold coordinates only
#include "pendulum.hpp"

struct System : rates_of_both<bodies<Bob, Block>, configuration_constraints<dot(s) == l>> {};

int main() { use_rates<System>(); }
