// expect: the covariance Q must have a row and a column for each independent coordinate and
// expect: speed, and the scalar type of the filter
#include "pendulum.hpp"

#include <kanexpr/control.hpp>

struct System : pendulum_with<Bob> {};
using filter = ekf<System, q>;

int main() {
  filter f{filter::state(), filter::covariance()};
  return f.predict(0, 0.1, parameter_values<System>(), input_values<System>(), Eigen::Matrix2f()) ? 0 : 1;
}
