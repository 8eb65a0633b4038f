// expect: the values of System are real numbers, but int holds only integers; use double
#include "pendulum.hpp"

struct System : pendulum_with<Bob> {};

int main() {
  state<System, int> x;
  x[q] = 1;
  return equations_of_motion<System>::mass_matrix(x, parameter_values<System>(1, 2)) > 0;
}
