// expect: a filter can measure only scalar and vector expressions of the model
#include "pendulum.hpp"

#include <kanexpr/control.hpp>

struct System : pendulum_with<Bob> {};
using filter = ekf<System, q, outer(A::x, A::y)>;

int main() {
  filter f{filter::state(), filter::covariance()};
  return f.update(Eigen::Vector2d(), parameter_values<System>(), input_values<System>(), Eigen::Matrix2d())
             ? 0
             : 1;
}
