// expect: the regressor requires constant masses and inertias; those of Leaking change
#include "pendulum.hpp"

struct Leaking : particle<Leaking, P, m * (2 - t)> {};
struct System : pendulum_with<Leaking> {};

int main() {
  const auto Y = regressor<System>::matrix(0.0, state<System>(), parameter_values<System>(),
                                           input_values<System>(), Eigen::Matrix<double, 1, 1>());
  return static_cast<int>(Y.rows());
}
