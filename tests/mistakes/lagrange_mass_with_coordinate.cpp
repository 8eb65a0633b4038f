// expect: the mass of Drop depends on coordinate q; with Lagrange's method it may depend only on time
#include "pendulum.hpp"

struct Drop : particle<Drop, P, m * q> {};

struct System : rates_of_pendulum<bodies<Drop>> {};

int main() { use_rates<System>(); }
