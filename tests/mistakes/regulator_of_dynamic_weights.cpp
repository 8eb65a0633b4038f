#include <kanexpr/control.hpp>

// expect: the size of the weights must be known at compile time
const auto regulator = kanexpr::lqr(Eigen::Matrix2d(), Eigen::Vector2d(), Eigen::VectorXd(2), {1});

int main() {}
