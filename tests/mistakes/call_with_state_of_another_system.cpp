// expect: mass_matrix of System is given the state of Other in place of its state
#include "pendulum.hpp"

struct System : pendulum_with<Bob> {};
struct Other : pendulum_with<Bob> {};

int main() {
  const state<Other> x;
  const parameter_values<System> p(1, 2);
  return equations_of_motion<System>::mass_matrix(x, p) > 0;
}
