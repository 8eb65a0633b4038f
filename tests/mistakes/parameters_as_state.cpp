// expect: System is given the parameters of System in place of its state
#include "pendulum.hpp"

struct System : pendulum_with<Bob> {};

int main() {
  const parameter_values<System> p(1, 2);
  const state<System> x = p;
  return x(0) > 0;
}
