// expect: the derivatives of velocity constraint 1 with respect to the rates of the coordinates vanish
// expect: wherever it holds
#include "pendulum.hpp"

struct System : rates_of_both<bodies<Bob, Block>,
                              velocity_constraints<(dot(q) - 2 * dot(s)) * (dot(q) - 2 * dot(s)) == 0>> {};

int main() { use_rates<System>(); }
