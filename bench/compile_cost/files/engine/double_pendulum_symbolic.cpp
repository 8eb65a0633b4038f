#include <models/double_pendulum.hpp>

#include <kanexpr/symbolic.hpp>

#include <iostream>

void print() {
  auto model = kanexpr::derive<double_pendulum::System>();
  std::cout << kanexpr::symbolic::print(model.udot()) << '\n';
  auto linear = model.linearize({{"q1", 0}, {"q2", 0}, {"u1", 0}, {"u2", 0}});
  std::cout << kanexpr::symbolic::print(linear.explicit_form().A) << '\n';
}
