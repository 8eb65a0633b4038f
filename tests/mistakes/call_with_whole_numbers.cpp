// expect: the values of System are real numbers, but int holds only integers; use double
#include "pendulum.hpp"

struct System : pendulum_with<Bob> {};

int main() {
  const Eigen::Vector2i x(1, 2);
  const parameter_values<System> p(1, 2);
  return equations_of_motion<System>::mass_matrix(x, p) > 0;
}
