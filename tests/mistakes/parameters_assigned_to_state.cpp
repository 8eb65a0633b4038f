// expect: System is given the parameters of System in place of its state
#include "pendulum.hpp"

struct System : pendulum_with<Bob> {};

int main() {
  state<System> x;
  x = parameter_values<System>(1, 2);
  return x(0) > 0;
}
