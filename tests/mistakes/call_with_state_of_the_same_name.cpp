// expect: mass_matrix of System is given the state of second::System in place of its state
#include "pendulum.hpp"

struct System : pendulum_with<Bob> {};
namespace second {
struct System : pendulum_with<Bob> {};
} // namespace second

int main() {
  const state<second::System> x;
  const parameter_values<System> p(1, 2);
  return equations_of_motion<System>::mass_matrix(x, p) > 0;
}
