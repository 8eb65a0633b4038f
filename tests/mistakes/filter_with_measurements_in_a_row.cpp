// expect: y and its covariance R have a row for each number that is measured, and the numbers of the filter
#include "pendulum.hpp"

#include <kanexpr/control.hpp>

struct System : pendulum_with<Bob> {};
using filter = ekf<System, velocity_of<P>>;

int main() {
  filter f{filter::state(), filter::covariance()};
  return f.update(Eigen::RowVector3d(), parameter_values<System>(), input_values<System>(), Eigen::Matrix3d())
             ? 0
             : 1;
}
