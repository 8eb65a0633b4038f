// expect: the offset of point F holds the rate of coordinate q; it may hold coordinates only
#include "pendulum.hpp"

struct F : offset<F, P, dot(q) * N::x> {};
struct Fly : particle<Fly, F, m> {};

struct System : rates_of_pendulum<bodies<Fly>> {};

int main() { use_rates<System>(); }
