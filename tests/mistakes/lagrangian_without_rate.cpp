// expect: coordinate s moves no mass
#include "pendulum.hpp"

struct System : rates_of_both<lagrangian<m * dot(q) * dot(q) - g * s * s>> {};

int main() { use_rates<System>(); }
