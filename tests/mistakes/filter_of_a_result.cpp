// expect: a filter can measure only scalar and vector expressions of the model
#include "pendulum.hpp"

#include <kanexpr/control.hpp>

struct System : pendulum_with<Bob> {};
using filter = ekf<System, mechanics::quantity::mass_matrix>;

int main() {
  filter f{filter::state(), filter::covariance()};
  return f.update(Eigen::Matrix<double, 1, 1>(), parameter_values<System>(), input_values<System>(),
                  Eigen::Matrix<double, 1, 1>())
             ? 0
             : 1;
}
