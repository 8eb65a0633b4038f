// expect: an expression contains a number that is not finite
#include "pendulum.hpp"

#include <limits>

struct System : pendulum_with<Bob> {};

int main() {
  constexpr function<System, q * std::numeric_limits<double>::infinity()> endless{};
  return endless(state<System>(), parameter_values<System>(1, 2)) > 0;
}
