// expect: the velocity of Skate is not the rate of its position, as Lagrange's method requires
#include "pendulum.hpp"

struct F : offset<F, O, s * N::x + q * N::y>, velocity<N, dot(s) * A::x> {};
struct Skate : particle<Skate, F, m> {};

struct System : rates_of_both<bodies<Skate, Bob>> {};

int main() { use_rates<System>(); }
