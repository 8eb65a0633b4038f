// expect: required inputs are defined only if there are as many inputs as independent speeds; there are 0
// expect: inputs for 1
#include "pendulum.hpp"

struct System : pendulum_with<Bob> {};
using eom = equations_of_motion<System>;

int main() {
  eom::required_inputs(eom::state(), eom::parameters(), eom::inputs(), Eigen::Matrix<double, 1, 1>(1.0));
}
