// expect: velocity constraint 1 is not linear in the rate of coordinate q
#include "pendulum.hpp"

struct System : rates_of_both<bodies<Bob, Block>, velocity_constraints<dot(q) * dot(s) == 1>> {};

int main() { use_rates<System>(); }
