// expect: the values of System are real numbers, and int holds whole numbers only; take double
#include "pendulum.hpp"

struct System : pendulum_with<Bob> {};

int main() {
  const Eigen::Vector2i x(1, 2);
  const parameter_values<System> p(1, 2);
  return equations_of_motion<System>::mass_matrix(x, p) > 0;
}
