// expect: dependent<...> contains something that is neither a coordinate nor the rate of one, involving v
#include "pendulum.hpp"

struct System : rates_of_both<bodies<Bob, Block>, velocity_constraints<dot(s) == dot(q)>, dependent<v>> {};

int main() { use_rates<System>(); }
