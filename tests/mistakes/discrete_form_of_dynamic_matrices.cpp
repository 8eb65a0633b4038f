#include <kanexpr/control.hpp>

// expect: the size of a matrix must be known at compile time
const auto form = kanexpr::discretize(Eigen::MatrixXd(2, 2), Eigen::VectorXd(2), 0.1);

int main() {}
