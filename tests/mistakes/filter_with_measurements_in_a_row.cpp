// expect: y and its covariance R must have a row for each measured component, and the scalar
// expect: type of the filter
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
