// expect: the offset of point F contains the rate of coordinate q; it may contain only coordinates
#include "pendulum.hpp"

struct F : offset<F, P, dot(q) * N::x> {};
struct Fly : particle<Fly, F, m> {};

struct System : rates_of_pendulum<bodies<Fly>> {};

int main() { use_rates<System>(); }
