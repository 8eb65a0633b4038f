// expect: System is given the state of System in place of its inputs
#include "pendulum.hpp"

#include <kanexpr/simulations/inputs/input_source.hpp>

struct System : pendulum_with<Bob> {};

int main() {
  input_source<System> inputs;
  inputs = state<System>(1, 2);
  return inputs.depends_on_state();
}
