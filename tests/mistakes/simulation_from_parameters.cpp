// expect: System is given the parameters of System in place of its state
#include "pendulum.hpp"

#include <kanexpr/compiled/named_values.hpp>

struct System : pendulum_with<Bob> {};

double first(const given_state<System>& x) { return x.values(0); }

int main() { return first(parameter_values<System>(1, 2)) > 0; }
