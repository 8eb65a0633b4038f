// expect: is longer than 60 characters
#include "pendulum.hpp"

constexpr parameter<"a_mass_with_a_name_that_nobody_would_want_to_write_more_than_once"> k;
struct Bead : particle<Bead, P, k> {};

struct System : pendulum_with<Bead> {};

int main() { use<System>(); }
