#include <kanexpr/control.hpp>

// expect: A and B have different numbers of rows
const auto regulator = kanexpr::lqr(Eigen::Matrix2d(), Eigen::Vector3d(), {1, 2}, {1});

int main() {}
