#include <kanexpr/control.hpp>

// expect: the scalar type of the weights is wider than that of A and B
const auto regulator = kanexpr::lqr(Eigen::Matrix2f(), Eigen::Vector2f(), Eigen::Vector2d(), {1});

int main() {}
