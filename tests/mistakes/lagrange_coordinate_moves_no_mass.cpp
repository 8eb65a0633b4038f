// expect: coordinate s moves no mass
#include "pendulum.hpp"

struct System : rates_of_both<bodies<Bob>> {};

int main() { use_rates<System>(); }
