#include <kanexpr/control.hpp>

// expect: the size of a matrix must be known at compile time
const auto regulator = kanexpr::lqr(Eigen::MatrixXd(2, 2), Eigen::VectorXd(2), {1, 2}, {1});

int main() {}
